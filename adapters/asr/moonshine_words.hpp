// The words of an application that its recogniser should know.
#pragma once

#include <string>
#include <vector>

#include "adapters/asr/moonshine_frames.hpp"
#include "runtime/plugin/plugin.hpp"

namespace parlour::adapters::moonshine {

// What `host` knows of the application; `columns` reads its columns, which may
// block. The values of sets and of database columns and the names in them; then
// what the grammars and the examples say. Each once, as it is written. Columns
// that cannot be read are left out.
// Empty where the host knows no application.
Words application_words(const PluginHost& host, const ColumnReader& columns);

// The runs of words in a JSGF grammar that are spoken as they stand: no rules,
// tags, weights or comments.
std::vector<std::string> grammar_words(const std::string& jsgf);

// The parts of an example: "I am [David](Visitor)" says "I am" and "David".
std::vector<std::string> example_words(const std::string& example);

} // namespace parlour::adapters::moonshine
