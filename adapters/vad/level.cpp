#include "adapters/vad/level.hpp"

#include <algorithm>
#include <cmath>

namespace parlour::adapters {

namespace {

// A high-pass filter of the first order: half the power at 300 Hz.
constexpr double keeps = 0.89;
constexpr double full_scale = 32'768;

} // namespace

double SpeechBandMeter::level(std::span<const Sample> audio) {
  if (audio.empty())
    return lowest_level;
  double power = 0;
  for (const auto sample : audio) {
    last_out_ = keeps * (last_out_ + sample - last_in_);
    last_in_ = sample;
    power += last_out_ * last_out_;
  }
  const auto mean = power / static_cast<double>(audio.size());
  if (mean <= 0)
    return lowest_level;
  return std::max(lowest_level,
                  10 * std::log10(mean / (full_scale * full_scale)));
}

} // namespace parlour::adapters
