// Resampler brings a stream of samples from one format to another: the rate by
// libsamplerate, the channels by mixing and copying.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "adapters/audio/pcm.hpp"
#include "adapters/audio/rate_converter.hpp"

namespace parlour::adapters {

// For one thread at a time.
class Resampler {
public:
  // Where the numbers of channels differ, all channels are mixed to one, which
  // then goes to each. Errors are those of RateConverter; none if only the
  // channels differ.
  static Expected<Resampler> create(const PcmFormat& from, const PcmFormat& to);

  // Appends the samples in the other format to `out`. The borders between the
  // pieces of a stream cannot be heard. A change of rate holds a few
  // milliseconds back. `samples` are whole frames of all channels.
  void process(std::span<const Sample> samples, std::vector<Sample>& out);
  // Appends what was held back. The next samples begin another stream.
  void finish(std::vector<Sample>& out);

private:
  Resampler(const PcmFormat& from, const PcmFormat& to,
            std::optional<RateConverter> converter);

  void spread(std::span<const float> mixed, std::vector<Sample>& out) const;

  PcmFormat from_;
  PcmFormat to_;
  int inner_; // channels while the rate is changed
  std::optional<RateConverter> converter_;
  std::vector<float> mixed_; // kept to be used again
  std::vector<float> converted_;
};

} // namespace parlour::adapters
