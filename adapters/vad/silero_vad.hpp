// SileroVAD is a plug-in for the role VAD: a neural network that knows voices
// from other sounds, in the program of the neural recogniser
// (tools/agents/moonshine), which this plug-in starts, watches and ends. Its
// commands and events are those of detector_plugin.hpp.
//
// Options: hangover (200ms), echo-loss in dB (10), program, node. If the
// program ends, does not read or does not answer in time, this instance has
// failed.
#pragma once

#include <filesystem>
#include <vector>

#include "runtime/plugin/plugin.hpp"

namespace parlour::adapters {

// `programs`: where moonshine.mjs may be, the best place first.
PluginFactory silero_vad_factory(std::vector<std::filesystem::path> programs);

// What it needs beside the program.
std::vector<std::string> silero_packages();

} // namespace parlour::adapters
