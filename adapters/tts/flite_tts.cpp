#include "adapters/tts/flite_tts.hpp"

#include "adapters/tts/engine_tts.hpp"
#include "adapters/tts/flite_synthesizer.hpp"

namespace parlour::adapters {

PluginFactory flite_tts_factory() {
  static tts::SharedEngine engine(tts::make_flite_synthesizer);
  PluginDescription description;
  description.name = "FliteTTS";
  description.roles = {"TTS"};
  description.sentence = "speaks English by flite: slt, rms, awb, kal16";
  description.options = tts::voice_options("slt");
  return {description, [options = description.options] {
            return std::make_unique<tts::EngineTTS>(engine, options);
          }};
}

} // namespace parlour::adapters
