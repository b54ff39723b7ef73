// WebRtcDetector finds speech by the voice detection of
// libwebrtc-audio-processing: by the spectrum, frame by frame. It hears one
// voice in noise well, and takes babble for speech.
#pragma once

#include <memory>

#include "adapters/vad/speech_detector.hpp"
#include "runtime/base/error.hpp"

namespace parlour::adapters {

struct WebRtcDetectorSettings {
  // 0: hears everything, and much that is none; 3: sure of what it calls
  // speech.
  int strictness = 2;
  int hangover = 200;    // ms
  double echo_loss = 10; // dB, as for AdaptiveDetector
};

// An error if the program was built without the library.
Expected<std::unique_ptr<SpeechDetector>>
make_webrtc_detector(const WebRtcDetectorSettings& settings);

} // namespace parlour::adapters
