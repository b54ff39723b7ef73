// Random: pseudo-random numbers that are the same on every machine for the same
// seed (SplitMix64). The state is one number, so a session can be written to
// bytes and continue with the same numbers. Not for secrets. Not thread-safe;
// each owner has its own generator.
#pragma once

#include <cstdint>

namespace parlour {

class Random {
public:
  // Any seed is good: sequences of neighbouring seeds are unrelated.
  explicit Random(std::uint64_t seed) : state_(seed) {}

  // All 64-bit numbers are equally likely.
  std::uint64_t next() {
    state_ += 0x9e3779b97f4a7c15;
    auto mixed = state_;
    mixed = (mixed ^ (mixed >> 30)) * 0xbf58476d1ce4e5b9;
    mixed = (mixed ^ (mixed >> 27)) * 0x94d049bb133111eb;
    return mixed ^ (mixed >> 31);
  }

  // At least 0 and less than 1, with 53 random bits.
  double fraction() {
    return static_cast<double>(next() >> 11) * 0x1p-53;
  }

  // The seed for a generator that continues where this one stands.
  std::uint64_t state() const {
    return state_;
  }

private:
  std::uint64_t state_;
};

} // namespace parlour
