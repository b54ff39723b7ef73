// AlsaDevice is one open device of ALSA, for capturing or playing. Sound has 16
// bit here, whatever the device has; its rate and channels are the device's.
//
// No call waits, as far as the device's driver keeps to that. For one thread at
// a time. Where the program was built without alsa-lib, open() says so
// (without_alsa.cpp).
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include <poll.h>

#include "adapters/audio/pcm.hpp"
#include "runtime/base/clock.hpp"

namespace parlour::adapters {

enum class SoundDirection : std::uint8_t { capture, playback };

struct WantedDevice {
  std::string name = "default"; // as ALSA knows it: "hw:1,0", "plughw:Headset"
  SoundDirection direction = SoundDirection::capture;
  // At most so much sound waits in a playing device to be heard.
  Milliseconds queue{40};
};

class AlsaDevice {
public:
  // The outcome of moving sound. The error is one of errno: EPIPE for an xrun,
  // ESTRPIPE for a suspended machine, others for a device that is broken or
  // gone; 0 if there is none.
  struct Moved {
    std::size_t samples = 0;
    int error = 0;
  };

  // The device is not started. Errors are of kind Settings if there is no such
  // device, and of kind Offline if it cannot be used now. Both say what else
  // can be done.
  static Expected<AlsaDevice> open(const WantedDevice& wanted);
  AlsaDevice(AlsaDevice&&) noexcept;
  AlsaDevice& operator=(AlsaDevice&&) noexcept;
  // Drops what has not been played.
  ~AlsaDevice();

  const PcmFormat& format() const;

  // Makes the device ready, also after an error; a capturing one starts, a
  // playing one when it gets sound. Returns an error of errno, or 0.
  int prepare();
  // Stops at once.
  void halt();

  // What to wait for.
  std::vector<pollfd> descriptors() const;
  // Whether sound can be moved, or an error be met, after waiting for them.
  bool is_ready(std::span<pollfd> waited) const;

  // Appends what was captured, but no more than `most` samples.
  Moved read(std::vector<Sample>& samples, std::size_t most);
  // How many samples write() would take.
  Moved room() const;
  // Takes as much as the queue has room for.
  Moved write(std::span<const Sample> samples);
  // Samples that wait in the device to be heard.
  std::size_t queued() const;

private:
  struct State;
  explicit AlsaDevice(std::unique_ptr<State> state);

  std::unique_ptr<State> state_;
};

} // namespace parlour::adapters
