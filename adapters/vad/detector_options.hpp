// The options that all detectors have: how long silence ends speech, and how
// much of the loudspeaker the microphone hears.
#pragma once

#include <vector>

#include "runtime/base/error.hpp"
#include "runtime/plugin/options.hpp"

namespace parlour::adapters {

struct DetectorOptions {
  int hangover = 0;     // milliseconds
  double echo_loss = 0; // dB
};

// `own` options of a detector, followed by those of all.
std::vector<OptionDescription>
detector_options(std::vector<OptionDescription> own = {});

// Errors are of kind Settings and say what an option takes.
Expected<DetectorOptions> read_detector_options(const Options& given);

} // namespace parlour::adapters
