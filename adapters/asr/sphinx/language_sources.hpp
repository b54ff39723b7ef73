// Gathers what an application says of its language: from the host, and from
// files of the application and the platform.
#pragma once

#include <vector>

#include "adapters/asr/words/language.hpp"
#include "runtime/plugin/plugin.hpp"

namespace parlour::adapters::asr {

// conversations, wordings, platform: of each recogniser.
const std::vector<OptionDescription>& language_options();

// The sources refer to the host. An error of kind Settings if a file that an
// option names cannot be read.
Expected<LanguageSources> language_sources(const PluginHost& host,
                                           const Options& options);

} // namespace parlour::adapters::asr
