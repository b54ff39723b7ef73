// The synthesizer of EspeakTTS: libespeak-ng.
#pragma once

#include <memory>

#include "adapters/tts/synthesizer.hpp"
#include "runtime/base/error.hpp"

namespace parlour::adapters::tts {

// Of espeak_synthesizer, or of what takes its place where the library is
// missing.
Expected<std::unique_ptr<Synthesizer>> make_espeak_synthesizer();

} // namespace parlour::adapters::tts
