// What takes the place of flite_synthesizer.cpp where flite is missing.
#include "adapters/tts/flite_synthesizer.hpp"

namespace parlour::adapters::tts {

Expected<std::unique_ptr<Synthesizer>> make_flite_synthesizer() {
  return fail(ErrorKind::settings,
              "this program was built without flite, so FliteTTS has no voice; "
              "install flite1-dev and build it again, or use EspeakTTS");
}

} // namespace parlour::adapters::tts
