// Tones, and how loud a tone is in samples.
#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <vector>

#include "adapters/audio/pcm.hpp"

namespace parlour::test {

// `level` is the amplitude, 1 for full scale.
inline std::vector<adapters::Sample> tone(double frequency, double level,
                                          std::size_t count,
                                          int rate = adapters::speech_rate) {
  std::vector<adapters::Sample> samples(count);
  for (std::size_t i = 0; i < count; ++i)
    samples[i] = static_cast<adapters::Sample>(
        std::lround(32'767 * level *
                    std::sin(2 * std::numbers::pi * frequency *
                             static_cast<double>(i) / rate)));
  return samples;
}

// The amplitude of the part of the samples that has this frequency; best over
// whole periods.
inline double level_of(std::span<const adapters::Sample> samples,
                       double frequency, int rate = adapters::speech_rate) {
  double real = 0;
  double imaginary = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const auto angle =
        2 * std::numbers::pi * frequency * static_cast<double>(i) / rate;
    real += samples[i] * std::cos(angle);
    imaginary += samples[i] * std::sin(angle);
  }
  return 2 * std::hypot(real, imaginary) / static_cast<double>(samples.size()) /
         32'767;
}

// Of the whole: root of the mean square, 1 for full scale.
inline double loudness(std::span<const adapters::Sample> samples) {
  double sum = 0;
  for (const double sample : samples)
    sum += sample * sample;
  return std::sqrt(sum / static_cast<double>(samples.size())) / 32'767;
}

inline double decibels(double ratio) {
  return 20 * std::log10(ratio);
}

} // namespace parlour::test
