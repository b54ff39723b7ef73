// synthesize: what a component of the role TTS makes of a text, without an
// application.
#pragma once

#include <string>
#include <vector>

#include "adapters/audio/pcm.hpp"
#include "runtime/plugin/plugin.hpp"

namespace parlour::tools {

// Starts the component alone, has it say the text, and stops it. The sound has
// 16,000 samples a second and one channel. Waits as long as the component goes
// on; one that says nothing for `patience` is given up.
Expected<std::vector<adapters::Sample>>
synthesize(const PluginFactory& factory, const Options& options,
           const std::string& text,
           Milliseconds patience = Milliseconds(30'000));

} // namespace parlour::tools
