// The sound devices of this machine, as ALSA lists them.
#pragma once

#include <string>
#include <vector>

#include "runtime/base/error.hpp"

namespace parlour::adapters {

struct SoundDevice {
  std::string name;        // for WantedDevice, such as "plughw:CARD=PCH,DEV=0"
  std::string description; // "HDA Intel PCH, ALC257 Analog", in one line
  bool captures = false;
  bool plays = false;
};

// Devices that only convert sound, or drop it, are left out. An error of kind
// Settings where the program was built without alsa-lib. May block for a
// moment.
Expected<std::vector<SoundDevice>> list_sound_devices();

} // namespace parlour::adapters
