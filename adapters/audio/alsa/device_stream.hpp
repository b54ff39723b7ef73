// DeviceStream is a thread that moves sound between a device of ALSA and its
// user, and brings the device back when it fails (DeviceRecovery).
//
// A device that hangs is closed and opened again. If a call into its driver
// never returns, stop() leaves the thread to itself; the user is not called any
// more.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "adapters/audio/alsa/alsa_device.hpp"
#include "adapters/audio/alsa/device_recovery.hpp"

namespace parlour::adapters {

// What a stream works for. It is called on the stream's thread, under a lock
// that stop() takes, so it must not wait for the thread that stops the stream.
class StreamUser {
public:
  virtual ~StreamUser() = default;

  // Whether sound is to be moved now. wake() after it has become true.
  virtual bool is_running() = 0;
  // A device has been opened, and its sound has this format.
  virtual void begin(const PcmFormat& format) = 0;
  // Capturing: what comes next. `lost` is how long nothing was captured before
  // it, because the device had failed.
  virtual void captured(std::span<const Sample>, Milliseconds /*lost*/) {}
  // Playing: appends about 10 ms that go out next.
  virtual void fill(std::vector<Sample>&) {}
  // Playing: so many samples of those that were filled have not been heard.
  virtual void waiting(std::size_t) {}
  // The device has been away for long; the stream goes on trying.
  virtual void lost(const std::string& reason) = 0;
  // The device that was lost works again.
  virtual void found() = 0;
};

struct StreamLimits {
  RecoveryLimits recovery = {};
  // A device that moves nothing for so long hangs.
  Milliseconds hang{1'000};
  // How long start() and stop() wait.
  Milliseconds patience{3'000};
  // A device that is faster than the clock by this factor is held back: some
  // take everything at once and play it nowhere.
  double fastest = 1.25;
};

class DeviceStream {
public:
  // Opens the device and starts the thread. Errors are those of
  // AlsaDevice::open(), and of kind Offline if that does not return. The user
  // must outlive the stream.
  static Expected<std::unique_ptr<DeviceStream>>
  start(const WantedDevice& wanted, const StreamLimits& limits,
        StreamUser& user);
  DeviceStream(const DeviceStream&) = delete;
  DeviceStream& operator=(const DeviceStream&) = delete;
  // Stops the stream if nobody has.
  ~DeviceStream();

  // The user may have something to do for the stream. Thread-safe.
  void wake();
  // After it has returned, the user is not called. False if the thread hangs in
  // the driver and was left to itself.
  bool stop();

private:
  struct Shared;
  explicit DeviceStream(std::shared_ptr<Shared> shared);

  std::shared_ptr<Shared> shared_; // also the thread's
};

} // namespace parlour::adapters
