// Speech that a detector found, compared with what was said. Times are in ms.
// Pure.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "adapters/audio/pcm.hpp"

namespace parlour::tools {

struct Segment {
  std::int64_t begin = 0;
  std::int64_t end = 0;

  bool operator==(const Segment&) const = default;
};

struct SegmentScore {
  std::size_t said = 0;
  std::size_t missed = 0; // nothing was found there
  std::size_t merged = 0; // with the line before
  std::size_t false_alarms = 0;
  // How far the beginning that was found is from the true one, of those that
  // were neither missed nor merged; the nearest first.
  std::vector<std::int64_t> delays;
};

// Both in the order of time.
SegmentScore compare_segments(const std::vector<Segment>& said,
                              const std::vector<Segment>& found);

// The trivial detector: what is louder than a fixed level, in dB, and 300 ms
// behind it.
std::vector<Segment> by_fixed_level(std::span<const adapters::Sample> sound,
                                    double level);

} // namespace parlour::tools
