// All that becomes rules of an application's automaton: grammars, examples, and
// values that may be said alone.
#pragma once

#include <vector>

#include "adapters/nlu/grammar/automaton_builder.hpp"
#include "adapters/nlu/values/schema.hpp"
#include "runtime/message/understanding.hpp"

namespace parlour::adapters::nlu {

// `generic` are the platform's grammars. Slots that do not exist, marks that do
// not fit together and errors of the notation go to `errors`.
void add_rules(const UnderstandingModel& model,
               const std::vector<GrammarModel>& generic, Schema& schema,
               AutomatonBuilder& builder, std::vector<Error>& errors);

} // namespace parlour::adapters::nlu
