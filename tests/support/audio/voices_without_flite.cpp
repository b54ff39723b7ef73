// The library flite was not found when the build was configured.
#include "tests/support/audio/voices.hpp"

namespace parlour::test {

bool can_speak() {
  return false;
}

Sound spoken(const std::string&, const std::string&) {
  return {};
}

Sound babble(std::uint64_t, std::int64_t, double) {
  return {};
}

} // namespace parlour::test
