#include "adapters/audio/mixing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

namespace parlour::adapters {

namespace {

constexpr double full_scale = 32'768;
constexpr double heard_range = 25;   // dB below the loudest
constexpr double silence_range = 35; // dB below the loudest

Sample clipped(double value) {
  return static_cast<Sample>(
      std::clamp(std::round(value), -32'768.0, 32'767.0));
}

double amplitude(double decibels) {
  return std::pow(10, decibels / 20);
}

// Between -1 and 1; the same on every machine.
double noise(std::mt19937_64& random) {
  return 2 * (static_cast<double>(random() >> 11) * 0x1.0p-53) - 1;
}

// Of each whole frame.
std::vector<double> levels_of(std::span<const Sample> sound) {
  std::vector<double> levels;
  for (std::size_t at = 0; at + frame_samples <= sound.size();
       at += frame_samples)
    levels.push_back(level_of(sound.subspan(at, frame_samples)));
  return levels;
}

} // namespace

double level_of(std::span<const Sample> sound) {
  double power = 0;
  for (const auto sample : sound)
    power += static_cast<double>(sample) * sample;
  const auto mean =
      power / static_cast<double>(std::max<std::size_t>(1, sound.size()));
  return mean > 0 ? 10 * std::log10(mean / (full_scale * full_scale)) : -120;
}

double speech_level_of(std::span<const Sample> sound) {
  const auto levels = levels_of(sound);
  if (levels.empty())
    return level_of(sound);
  const auto loudest = *std::ranges::max_element(levels);
  double power = 0;
  std::size_t count = 0;
  for (const auto level : levels)
    if (level > loudest - heard_range) {
      power += std::pow(10, level / 10);
      ++count;
    }
  return 10 * std::log10(power / static_cast<double>(count));
}

Sound at_level(Sound sound, double from, double to) {
  const auto factor = amplitude(to - from);
  for (auto& sample : sound)
    sample = clipped(sample * factor);
  return sound;
}

Sound sound_of(std::span<const double> values, double level) {
  double power = 0;
  for (const auto value : values)
    power += value * value;
  const auto mean =
      power / static_cast<double>(std::max<std::size_t>(1, values.size()));
  const auto factor =
      mean > 0 ? full_scale * amplitude(level) / std::sqrt(mean) : 0;
  Sound made(values.size());
  std::ranges::transform(values, made.begin(),
                         [&](double value) { return clipped(value * factor); });
  return made;
}

void add(Sound& to, std::span<const Sample> sound, std::size_t at) {
  for (std::size_t i = 0; i < sound.size() && at + i < to.size(); ++i)
    to[at + i] = clipped(static_cast<double>(to[at + i]) + sound[i]);
}

Sound without_silence(const Sound& sound) {
  const auto levels = levels_of(sound);
  if (levels.empty())
    return sound;
  const auto least = *std::ranges::max_element(levels) - silence_range;
  auto is_heard = [&](double level) { return level > least; };
  const auto first = std::ranges::find_if(levels, is_heard) - levels.begin();
  const auto last = std::find_if(levels.rbegin(), levels.rend(), is_heard);
  const auto end = levels.rend() - last;
  const auto size = static_cast<std::ptrdiff_t>(frame_samples);
  return {sound.begin() + first * size, sound.begin() + end * size};
}

// White noise through filters of the first order, one for each two octaves.
Sound pink_noise(std::uint64_t seed, std::int64_t milliseconds, double level) {
  std::mt19937_64 random(seed);
  std::vector<double> values(samples_in(milliseconds));
  constexpr std::array<double, 6> keeps{0.9975, 0.990, 0.963, 0.86, 0.55, 0};
  std::array<double, 6> state{};
  for (auto& value : values)
    for (std::size_t band = 0; band < keeps.size(); ++band) {
      const auto gain = std::sqrt(1 - keeps[band]);
      state[band] = keeps[band] * state[band] + gain * noise(random);
      value += state[band];
    }
  return sound_of(values, level);
}

Sound white_noise(std::uint64_t seed, std::int64_t milliseconds, double level) {
  std::mt19937_64 random(seed);
  std::vector<double> values(samples_in(milliseconds));
  for (auto& value : values)
    value = noise(random);
  return sound_of(values, level);
}

} // namespace parlour::adapters
