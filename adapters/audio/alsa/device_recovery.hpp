// DeviceRecovery decides what is done about a sound device that fails: how
// often it is started again, when it is opened anew, and when somebody is told.
// It touches no device.
//
//  a glitch (xrun, suspend)   the device is prepared again after a short pause;
//                             too many of them within some seconds: it is
//                             broken
//  broken                     the device is closed, and opened again after a
//                             pause that grows
//  broken for long            is reported, once; the attempts go on
//  works again for a while    everything is forgotten
#pragma once

#include <chrono>
#include <optional>

#include "runtime/base/clock.hpp"

namespace parlour::adapters {

struct RecoveryLimits {
  int glitches = 10;
  Milliseconds glitch_pause{5}; // doubled by each glitch; the first has none
  Milliseconds longest_glitch_pause{100};
  Milliseconds open_pause{50}; // doubled by each attempt
  Milliseconds longest_open_pause{5'000};
  Milliseconds report_after{1'000};
  Milliseconds stable_after{1'000};
};

// For one thread at a time.
class DeviceRecovery {
public:
  using Moment = std::chrono::steady_clock::time_point;

  explicit DeviceRecovery(RecoveryLimits limits = {});

  // How long to wait before the device is prepared; nothing if it is broken.
  std::optional<Milliseconds> glitch(Moment now);
  // How long to wait before the device is opened again.
  Milliseconds broken(Moment now);
  // Whether the outage is to be reported now; true once for each outage.
  bool must_report(Moment now);
  // Sound has passed. True if a reported outage is over.
  bool works(Moment now);

private:
  const RecoveryLimits limits_;
  int glitches_ = 0;
  int attempts_ = 0; // to open it
  bool reported_ = false;
  std::optional<Moment> broken_since_;
  std::optional<Moment> works_since_;
};

} // namespace parlour::adapters
