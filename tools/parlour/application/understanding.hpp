// The understanding of an application without a running session, as GrammarNLU
// builds it: for `check` and `parlour understand`.
#pragma once

#include <vector>

#include "adapters/nlu/understand/understander.hpp"
#include "tools/parlour/application/application.hpp"

namespace parlour::tools {

// All errors of options, grammars, examples and columns.
tl::expected<adapters::nlu::Understander, std::vector<Error>>
build_understander(const Application& application,
                   const ChosenComponent& component,
                   const ColumnReader& columns);

} // namespace parlour::tools
