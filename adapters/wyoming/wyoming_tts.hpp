// WyomingTTS is a plug-in for the role TTS that has texts spoken by a server of
// the Wyoming protocol, such as piper. engine_tts.hpp describes its commands.
// The protocol has no marks: the position of a word is estimated by its place
// in the text.
//
// Options: those of client.hpp; voice, language, ahead.
#pragma once

#include <memory>

#include "adapters/tts/engine_tts.hpp"
#include "adapters/wyoming/client.hpp"

namespace parlour::adapters {

// `client_` is there before the engine makes its synthesizer, and goes after
// it.
class WyomingTTS : public tts::EngineTTS {
public:
  WyomingTTS();
  ~WyomingTTS() override;
  void stop() override;

protected:
  Expected<void> on_start(const Options& options) override;

private:
  std::unique_ptr<wyoming::Client> client_;
  std::string language_;
  // Of this instance alone: another one may have another server.
  tts::SharedEngine engine_;
};

PluginFactory wyoming_tts_factory();

} // namespace parlour::adapters
