// EspeakTTS is a plug-in for the role TTS that speaks by libespeak-ng: more
// than a hundred languages, first sound within milliseconds. engine_tts.hpp
// describes its commands and options.
//
// The library has one global engine. Whoever else in the process wants
// something of it asks espeak_engine().
#pragma once

#include "adapters/tts/speech_engine.hpp"
#include "runtime/plugin/plugin.hpp"

namespace parlour::adapters {

namespace tts {

// Errors if the library is missing, or its data.
SharedEngine& espeak_engine();

} // namespace tts

PluginFactory espeak_tts_factory();

} // namespace parlour::adapters
