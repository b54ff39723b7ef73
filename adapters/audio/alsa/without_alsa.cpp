// What takes the place of alsa_device.cpp and alsa_device_list.cpp where
// alsa-lib is missing.
#include "adapters/audio/alsa/alsa_device.hpp"
#include "adapters/audio/alsa/alsa_device_list.hpp"

namespace parlour::adapters {

namespace {

tl::unexpected<Error> missing() {
  return fail(ErrorKind::settings,
              "this program was built without alsa-lib, so it can use no "
              "sound device; install libasound2-dev and build it again, or "
              "use FileMicrophone and FileSpeaker");
}

} // namespace

Expected<std::vector<SoundDevice>> list_sound_devices() {
  return missing();
}

struct AlsaDevice::State {
  PcmFormat format;
};

Expected<AlsaDevice> AlsaDevice::open(const WantedDevice&) {
  return missing();
}

AlsaDevice::AlsaDevice(AlsaDevice&&) noexcept = default;

AlsaDevice& AlsaDevice::operator=(AlsaDevice&&) noexcept = default;

AlsaDevice::~AlsaDevice() = default;

const PcmFormat& AlsaDevice::format() const {
  return state_->format;
}

int AlsaDevice::prepare() {
  return 0;
}

void AlsaDevice::halt() {}

std::vector<pollfd> AlsaDevice::descriptors() const {
  return {};
}

bool AlsaDevice::is_ready(std::span<pollfd>) const {
  return false;
}

AlsaDevice::Moved AlsaDevice::read(std::vector<Sample>&, std::size_t) {
  return {};
}

AlsaDevice::Moved AlsaDevice::room() const {
  return {};
}

AlsaDevice::Moved AlsaDevice::write(std::span<const Sample>) {
  return {};
}

std::size_t AlsaDevice::queued() const {
  return 0;
}

} // namespace parlour::adapters
