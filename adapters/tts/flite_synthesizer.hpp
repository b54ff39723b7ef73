// The synthesizer of FliteTTS: flite.
#pragma once

#include <memory>

#include "adapters/tts/synthesizer.hpp"
#include "runtime/base/error.hpp"

namespace parlour::adapters::tts {

// Of flite_synthesizer, or of what takes its place where the library is
// missing.
Expected<std::unique_ptr<Synthesizer>> make_flite_synthesizer();

} // namespace parlour::adapters::tts
