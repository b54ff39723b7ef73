// Random: numbers that look drawn by lot and are the same everywhere for the
// same seed (SplitMix64). The state is one number, so that a session can be
// written out and go on with the same numbers. Not for secrets. Not
// thread-safe; each owner has its own.
#pragma once

#include <cstdint>

namespace parlour {

class Random {
public:
  // Any number will do; neighbours give unlike sequences.
  explicit Random(std::uint64_t seed) : state_(seed) {}

  // Every number of 64 bits, equally often.
  std::uint64_t next() {
    state_ += 0x9e3779b97f4a7c15;
    auto mixed = state_;
    mixed = (mixed ^ (mixed >> 30)) * 0xbf58476d1ce4e5b9;
    mixed = (mixed ^ (mixed >> 27)) * 0x94d049bb133111eb;
    return mixed ^ (mixed >> 31);
  }

  // At least 0 and less than 1.
  double fraction() {
    return static_cast<double>(next() >> 11) * 0x1p-53;
  }

  // The seed of a generator that goes on where this one stands.
  std::uint64_t state() const {
    return state_;
  }

private:
  std::uint64_t state_;
};

} // namespace parlour
