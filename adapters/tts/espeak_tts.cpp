#include "adapters/tts/espeak_tts.hpp"

#include "adapters/tts/engine_tts.hpp"
#include "adapters/tts/espeak_synthesizer.hpp"

namespace parlour::adapters {

namespace tts {

SharedEngine& espeak_engine() {
  static SharedEngine engine(make_espeak_synthesizer);
  return engine;
}

} // namespace tts

PluginFactory espeak_tts_factory() {
  PluginDescription description;
  description.name = "EspeakTTS";
  description.roles = {"TTS"};
  description.sentence = "speaks by espeak-ng: many languages, sound at once";
  description.options = tts::voice_options("en-us");
  return {description, [options = description.options] {
            return std::make_unique<tts::EngineTTS>(tts::espeak_engine(),
                                                    options);
          }};
}

} // namespace parlour::adapters
