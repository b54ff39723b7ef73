// Many rules begin alike: "I am …", "can you …". Their arcs lead to states of
// their own, so that the matcher would carry a partial match for each rule.
// Merged, what begins alike is one way until it differs.
#pragma once

#include "adapters/nlu/grammar/automaton.hpp"

namespace parlour::adapters::nlu {

// The same matches with the same scores and meanings, by fewer ways: arcs of a
// state with the same symbol, actions and weight become one, to a state that
// has the arcs of all their targets (the subset construction). Where that would
// make the automaton much larger, arcs stay apart.
Automaton merge_states(Automaton automaton);

} // namespace parlour::adapters::nlu
