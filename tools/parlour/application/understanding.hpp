// Builds the understanding of an application without a session, exactly as the
// component GrammarNLU does when it starts.
#pragma once

#include <vector>

#include "adapters/nlu/understand/left_out.hpp"
#include "adapters/nlu/understand/nlu_engine.hpp"
#include "tools/parlour/application/application.hpp"

namespace parlour::tools {

// The engine, or all errors in options, grammars, examples and columns.
// `component` must be a GrammarNLU. `columns` is only called during the build.
tl::expected<adapters::nlu::NluEngine, std::vector<Error>>
build_engine(const Application& application, const ChosenComponent& component,
             const ColumnReader& columns);

// Reads the examples of the components that learn from them, each as if it were
// not there. For an application without errors.
std::vector<adapters::nlu::LeftOutExample>
try_examples(const Application& application);

// The context of a first turn: the start state's grammar and the time, no
// slots.
Map first_context(const script::Program& program, Timestamp now);

// With what else a recogniser heard, texts or maps with one.
Map with_alternatives(Map context, const List& alternatives);

} // namespace parlour::tools
