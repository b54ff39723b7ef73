// WebRtcVAD is a plug-in for the role VAD around the voice detection of
// libwebrtc-audio-processing (webrtc_detector.hpp). Its commands and events are
// those of detector_plugin.hpp.
//
// Options: strictness 0 to 3 (2), hangover (200ms), echo-loss in dB (10).
#pragma once

#include "runtime/plugin/plugin.hpp"

namespace parlour::adapters {

PluginFactory webrtc_vad_factory();

} // namespace parlour::adapters
