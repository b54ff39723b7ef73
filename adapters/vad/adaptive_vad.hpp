// AdaptiveVAD is a plug-in for the role VAD that finds speech by its level,
// above whatever noise there is (adaptive_detector.hpp). Its commands and
// events are those of detector_plugin.hpp.
//
// Options: hangover (200ms), echo-loss in dB (10).
#pragma once

#include "runtime/plugin/plugin.hpp"

namespace parlour::adapters {

PluginFactory adaptive_vad_factory();

} // namespace parlour::adapters
