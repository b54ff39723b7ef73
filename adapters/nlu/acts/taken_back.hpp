// What is taken back in the breath in which it is said: values of a list, "two
// teas and a beer, no, no beer", "a burger without chips", "the curry, no,
// actually the fish"; and all of it, "a taxi at noon, forget it".
#pragma once

#include <vector>

#include "adapters/nlu/parse/built_act.hpp"

namespace parlour::adapters::nlu {

// Leaves such values out of the acts. Where one was not said before in the same
// utterance, it may have been in an earlier one: then a "deny" says that it is
// not wanted, if the conversation is about its topic. Acts that have lost all
// of their values are left out.
void leave_out_taken_back(std::vector<BuiltAct>& acts,
                          const Utterance& utterance, const Spans& spans,
                          const Schema& schema, const Context& context);

// Leaves out the acts about tasks that a plain cancel ends, or, while nothing
// is asked, a plain no that is the last word. Whether there were some.
bool leave_out_withdrawn(std::vector<BuiltAct>& acts,
                         const Utterance& utterance, const Schema& schema,
                         const Context& context);

} // namespace parlour::adapters::nlu
