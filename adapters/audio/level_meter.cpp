#include "adapters/audio/level_meter.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace parlour::adapters {

namespace {

constexpr int full_scale = 32'768;

// `amplitude` is from 0 to full scale.
double decibels(double amplitude) {
  return amplitude <= 0 ? LevelMeter::floor
                        : std::max(LevelMeter::floor,
                                   20 * std::log10(amplitude / full_scale));
}

} // namespace

void LevelMeter::add(std::span<const Sample> samples) {
  for (const int sample : samples) {
    sum_ += sample;
    squares_ += std::int64_t{sample} * sample;
    peak_ = std::max(peak_, std::abs(sample));
    clipped_ += sample <= -full_scale + 1 || sample >= full_scale - 1;
  }
  samples_ += samples.size();
}

void LevelMeter::reset() {
  *this = {};
}

double LevelMeter::level() const {
  if (samples_ == 0)
    return floor;
  const auto count = static_cast<double>(samples_);
  const auto mean = static_cast<double>(sum_) / count;
  const auto power = static_cast<double>(squares_) / count - mean * mean;
  return decibels(std::sqrt(std::max(power, 0.0)));
}

double LevelMeter::peak() const {
  return decibels(peak_);
}

double LevelMeter::clipped() const {
  return samples_ == 0
             ? 0
             : static_cast<double>(clipped_) / static_cast<double>(samples_);
}

} // namespace parlour::adapters
