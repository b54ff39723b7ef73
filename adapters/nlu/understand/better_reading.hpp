// Chooses between what grammars found and what was learnt of examples and
// wordings (docs/understanding.md).
#pragma once

#include <vector>

#include "adapters/nlu/parse/built_act.hpp"
#include "adapters/nlu/parse/context.hpp"

namespace parlour::adapters::nlu {

// Whether the acts that grammars found are so few or so weak that the examples
// may know more.
bool leaves_open(const std::vector<BuiltAct>& acts);

// Puts the hypothesis in the place of the acts if it is better; otherwise adds
// the slots that it found beside them. True if it took their place. A bare
// value about the topic that the context expects is kept, whatever the examples
// say. One that is `well_taught` is also better than a whole sentence that was
// understood in part, about what nobody expects.
bool prefer_better(std::vector<BuiltAct>& acts, const BuiltAct& hypothesis,
                   const Schema& schema, const Context& context,
                   bool well_taught);

} // namespace parlour::adapters::nlu
