// What takes the place of webrtc_echo_canceller.cpp where the library is
// missing.
#include "adapters/enhancement/echo_canceller.hpp"

namespace parlour::adapters {

struct EchoCanceller::Implementation {};

Expected<EchoCanceller> EchoCanceller::make(const Settings&) {
  return fail(ErrorKind::settings,
              "this program was built without libwebrtc-audio-processing; "
              "install libwebrtc-audio-processing-dev and build it again, or "
              "leave out the enhancement");
}

EchoCanceller::EchoCanceller(EchoCanceller&&) noexcept = default;
EchoCanceller& EchoCanceller::operator=(EchoCanceller&&) noexcept = default;
EchoCanceller::~EchoCanceller() = default;

void EchoCanceller::played(std::span<const Sample>) {}

std::vector<Sample> EchoCanceller::heard(std::span<const Sample> audio) {
  return {audio.begin(), audio.end()};
}

} // namespace parlour::adapters
