// What takes the place of webrtc_detector.cpp where the library is missing.
#include "adapters/vad/webrtc_detector.hpp"

namespace parlour::adapters {

Expected<std::unique_ptr<SpeechDetector>>
make_webrtc_detector(const WebRtcDetectorSettings&) {
  return fail(ErrorKind::settings,
              "this program was built without libwebrtc-audio-processing; "
              "install libwebrtc-audio-processing-dev and build it again, or "
              "use AdaptiveVAD");
}

} // namespace parlour::adapters
