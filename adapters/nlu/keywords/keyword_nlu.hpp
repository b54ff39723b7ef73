// KeywordNLU is a second plug-in for the role NLU, for applications with a few
// commands. It has no grammars and no examples: only words that name a topic,
// and values that fill its slots. It answers DoNLU(text, context?) with
// FrameInfo(act…) or NoResult(text).
//
// Option: rules, a file of the application's folder (keyword_rules.hpp).
#pragma once

#include <filesystem>

#include "adapters/nlu/keywords/keyword_rules.hpp"
#include "runtime/plugin/plugin.hpp"

namespace parlour::adapters {

PluginFactory keyword_nlu_factory();

// Reads the file of rules that the options name, or returns all errors.
tl::expected<nlu::KeywordRules, std::vector<Error>> load_keyword_rules(
    const Options& options, const std::string& application_folder,
    const UnderstandingModel& model, const ColumnReader& columns);

} // namespace parlour::adapters
