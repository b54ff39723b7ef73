// KeywordNLU: a second plug-in for the role NLU: no grammars and no examples,
// only words that tell a topic and values that fill its slots. For what has a
// few commands. Answers DoNLU(text, context?) with FrameInfo(act…) or
// NoResult(text).
//
// Options: rules, a file of the application's folder (keyword_rules.hpp).
#pragma once

#include <filesystem>

#include "adapters/nlu/keywords/keyword_rules.hpp"
#include "runtime/plugin/plugin.hpp"

namespace parlour::adapters {

PluginFactory keyword_nlu_factory();

// The rules that the options choose, with all that is wrong with them.
tl::expected<nlu::KeywordRules, std::vector<Error>> load_keyword_rules(
    const Options& options, const std::string& application_folder,
    const UnderstandingModel& model, const ColumnReader& columns);

} // namespace parlour::adapters
