#include "tests/support/audio/sounds.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace parlour::test {

namespace {

using adapters::Sample;

Sample clipped(double value) {
  return static_cast<Sample>(
      std::clamp(std::round(value), -32'768.0, 32'767.0));
}

double amplitude(double decibels) {
  return std::pow(10, decibels / 20);
}

// Between 0 and 1; the same on every machine.
double uniform(std::mt19937_64& random) {
  return static_cast<double>(random() >> 11) * 0x1.0p-53;
}

// One syllable: harmonics below two formants, with a soft beginning and end.
void add_syllable(std::vector<double>& to, std::size_t at, std::size_t length,
                  std::mt19937_64& random) {
  const auto pitch = 90 + 140 * uniform(random);
  const auto first = 300 + 500 * uniform(random);
  const auto second = 1'000 + 1'200 * uniform(random);
  const auto loudness = 0.5 + uniform(random);
  for (int harmonic = 1; harmonic * pitch < 3'500; ++harmonic) {
    const auto frequency = harmonic * pitch;
    const auto gain =
        loudness * (std::exp(-std::abs(frequency - first) / 250) +
                    0.4 * std::exp(-std::abs(frequency - second) / 300));
    const auto step = 2 * std::numbers::pi * frequency / adapters::speech_rate;
    for (std::size_t i = 0; i < length && at + i < to.size(); ++i) {
      const auto edge = std::min({1.0, static_cast<double>(i + 1) / 240,
                                  static_cast<double>(length - i) / 480});
      to[at + i] += edge * gain * std::sin(step * static_cast<double>(i));
    }
  }
}

} // namespace

Sound silence(std::int64_t milliseconds) {
  return Sound(samples_in(milliseconds));
}

Sound tone(double hertz, std::int64_t milliseconds, double level) {
  std::vector<double> values(samples_in(milliseconds));
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = std::sin(2 * std::numbers::pi * hertz * static_cast<double>(i) /
                         adapters::speech_rate);
  return adapters::sound_of(values, level);
}

Sound speech_like(std::uint64_t seed, std::int64_t milliseconds, double level) {
  std::mt19937_64 random(seed);
  std::vector<double> values(samples_in(milliseconds));
  std::size_t at = 0;
  while (at < values.size()) {
    auto length =
        samples_in(120 + static_cast<std::int64_t>(140 * uniform(random)));
    const auto pause =
        samples_in(20 + static_cast<std::int64_t>(90 * uniform(random)));
    // What would be left is part of the last one.
    if (at + length + pause + samples_in(120) > values.size())
      length = values.size() - at;
    add_syllable(values, at, length, random);
    at += length + pause;
  }
  return adapters::sound_of(values, level);
}

Sound speech_like_babble(std::uint64_t seed, std::int64_t milliseconds,
                         double level, int voices) {
  Sound babble(samples_in(milliseconds));
  std::mt19937_64 random(seed);
  for (int voice = 0; voice < voices; ++voice) {
    std::size_t at = 0;
    while (at < babble.size()) {
      const auto length =
          800 + static_cast<std::int64_t>(2'500 * uniform(random));
      add(babble, speech_like(random(), length, -36 + 6 * uniform(random)), at);
      at += samples_in(length + 200 +
                       static_cast<std::int64_t>(800 * uniform(random)));
    }
  }
  const auto now = level_of(babble);
  return at_level(std::move(babble), now, level);
}

void add_noise(Sound& speech, const Sound& noise, double decibels,
               std::uint64_t seed) {
  if (noise.empty())
    return;
  std::mt19937_64 random(seed);
  const auto factor =
      amplitude(speech_level_of(speech) - decibels - level_of(noise));
  auto at = static_cast<std::size_t>(random() % noise.size());
  for (auto& sample : speech) {
    sample = clipped(sample + factor * noise[at]);
    at = at + 1 == noise.size() ? 0 : at + 1;
  }
}

Sound mixed_loops(const Sound& one, const Sound& other, std::size_t at,
                  std::size_t length) {
  Sound mixed(length);
  for (std::size_t i = 0; i < length; ++i)
    mixed[i] = static_cast<Sample>(
        (one[(at + i) % one.size()] + other[(at + i) % other.size()]) / 2);
  return mixed;
}

} // namespace parlour::test
