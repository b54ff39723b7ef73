// GrammarNLU is the plug-in for the role NLU. It answers DoNLU(text, context?)
// with FrameInfo(act…) or NoResult(text). docs/understanding.md describes what
// it understands.
//
//  option     default
//  threshold  0.4   acts with a lower score are not understood
//  examples         a file of the application with further examples
//  platform         the folder config/platform; the composition root sets it
//  generic          a grammar of the application that replaces the platform's
//                   generic-acts.jsgf
//
// Names and values are read from the database at the start; SetValues(column,
// values) tells of new ones (engine rule 1.9).
#pragma once

#include "adapters/nlu/understand/left_out.hpp"
#include "adapters/nlu/understand/nlu_engine.hpp"
#include "runtime/plugin/plugin.hpp"

namespace parlour::adapters {

PluginFactory grammar_nlu_factory();

namespace nlu {

// Reads a grammar from a file; its name is that of the file.
Expected<GrammarModel> read_grammar(const std::string& path);

// Reads what the options choose of the platform: the grammar of generic acts,
// synonyms, word vectors. The application's folder is an absolute path. Returns
// all errors if there are any.
tl::expected<NluEngine::Options, std::vector<Error>>
read_platform(const Options& options, const std::string& application_folder);

// All that an engine is built from but the values of columns.
struct EngineSources {
  UnderstandingModel model; // with the examples of the application's file
  NluEngine::Options platform;
  std::vector<Error> errors; // why something of it is missing
};
EngineSources read_sources(const Options& options, UnderstandingModel model,
                           const std::string& application_folder);

// Builds the engine for an application, or returns all errors, those of the
// sources first.
tl::expected<NluEngine, std::vector<Error>>
build_engine(const EngineSources& sources, const ColumnReader& columns);
tl::expected<NluEngine, std::vector<Error>>
build_engine(const Options& options, UnderstandingModel model,
             const ColumnReader& columns,
             const std::string& application_folder);

// Reads the application's examples, those of its file too, as if each were not
// there (left_out.hpp). Empty if something is wrong, which build_engine tells.
std::vector<LeftOutExample> try_examples(const Options& options,
                                         UnderstandingModel model,
                                         const ColumnReader& columns,
                                         const std::string& application_folder);

} // namespace nlu

} // namespace parlour::adapters
