// GrammarNLU: the plug-in for the role NLU. Answers DoNLU(text, context?) with
// FrameInfo(act…) or NoResult(text) (understanding; roles).
//
// Options: threshold (0.4); examples, a file of the application's folder with
// further examples (example_file.hpp); platform, the folder of what the
// platform ships (config/platform), set by the composition root; generic, a
// file of the application's folder instead of its generic-acts.jsgf.
//
// Names and values are read from the database once, at start: what is written
// to it later is understood after the next start.
#pragma once

#include "adapters/nlu/understand/understander.hpp"
#include "runtime/plugin/plugin.hpp"

namespace parlour::adapters {

PluginFactory grammar_nlu_factory();

namespace nlu {

// A grammar's file as it is.
Expected<GrammarModel> read_grammar(const std::string& path);

// The grammar of generic acts that the options choose. The application's folder
// is absolute.
Expected<GrammarModel> read_generic(const Options& options,
                                    const std::string& application_folder);

// What the options and the application make; otherwise all that is wrong.
tl::expected<Understander, std::vector<Error>>
build_understander(const Options& options, UnderstandingModel model,
                   const ColumnReader& columns,
                   const std::string& application_folder);

} // namespace nlu

} // namespace parlour::adapters
