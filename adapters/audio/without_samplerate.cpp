// What takes the place of rate_converter.cpp where libsamplerate is missing.
#include "adapters/audio/rate_converter.hpp"

namespace parlour::adapters {

struct RateConverter::State {};

Expected<RateConverter> RateConverter::create(int from, int to, int) {
  return fail(ErrorKind::settings,
              "this program was built without libsamplerate, so it cannot "
              "change the rate " +
                  std::to_string(from) + " to " + std::to_string(to) +
                  "; install libsamplerate0-dev and build it again");
}

RateConverter::RateConverter(RateConverter&&) noexcept = default;

RateConverter& RateConverter::operator=(RateConverter&&) noexcept = default;

RateConverter::~RateConverter() = default;

void RateConverter::process(std::span<const float>, std::vector<float>&) {}

void RateConverter::finish(std::vector<float>&) {}

} // namespace parlour::adapters
