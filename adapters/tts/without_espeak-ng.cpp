// What takes the place of espeak_synthesizer.cpp where libespeak-ng is missing.
#include "adapters/tts/espeak_synthesizer.hpp"

namespace parlour::adapters::tts {

Expected<std::unique_ptr<Synthesizer>> make_espeak_synthesizer() {
  return fail(ErrorKind::settings,
              "this program was built without libespeak-ng, so EspeakTTS has "
              "no voice; install libespeak-ng-dev and build it again, or use "
              "TextFileTTS");
}

} // namespace parlour::adapters::tts
