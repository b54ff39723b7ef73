// LevelMeter says how loud sound is, and whether it is too loud.
#pragma once

#include <cstdint>
#include <span>

#include "adapters/audio/pcm.hpp"

namespace parlour::adapters {

// Of 16 bit samples; for one thread at a time.
class LevelMeter {
public:
  // In decibels below full scale; silence is `floor`.
  static constexpr double floor = -100;

  void add(std::span<const Sample> samples);
  // Begins anew.
  void reset();

  std::uint64_t samples() const {
    return samples_;
  }
  // Root of the mean square, without what is the same in all samples: cheap
  // devices have such an offset. A sine of full scale is -3 dB.
  double level() const;
  double peak() const;
  // The part of the samples at full scale, 0 to 1. One of a thousand is heard.
  double clipped() const;

private:
  std::uint64_t samples_ = 0;
  std::uint64_t clipped_ = 0;
  std::int64_t sum_ = 0;
  std::int64_t squares_ = 0;
  int peak_ = 0;
};

} // namespace parlour::adapters
