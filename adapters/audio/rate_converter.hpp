// RateConverter changes the rate of a stream of samples, by libsamplerate.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "runtime/base/error.hpp"

namespace parlour::adapters {

// For one thread at a time.
class RateConverter {
public:
  // Rates are samples a second; samples of several channels are interleaved.
  // An error of kind Settings: the program was built without the library, or
  // the library cannot do that.
  static Expected<RateConverter> create(int from, int to, int channels);
  RateConverter(RateConverter&&) noexcept;
  RateConverter& operator=(RateConverter&&) noexcept;
  ~RateConverter();

  // Appends to `out` what can be said so far: a few milliseconds are held back
  // until their successors are known. Samples are from -1 to 1, and whole
  // frames of all channels.
  void process(std::span<const float> samples, std::vector<float>& out);
  // Appends what is held back. The next samples begin another stream.
  void finish(std::vector<float>& out);

private:
  struct State;
  explicit RateConverter(std::unique_ptr<State> state);

  std::unique_ptr<State> state_;
};

} // namespace parlour::adapters
