// FliteTTS is a plug-in for the role TTS that speaks English by flite: voices
// that sound nicer than espeak-ng's and take longer. engine_tts.hpp describes
// its commands and options. The samples of a text differ a little from time to
// time; their number does not.
#pragma once

#include "runtime/plugin/plugin.hpp"

namespace parlour::adapters {

PluginFactory flite_tts_factory();

} // namespace parlour::adapters
