// Of several islands that take the same words, which one is meant
// (understanding, "Yes and no" and "Score").
#pragma once

#include <vector>

#include "adapters/nlu/parse/context.hpp"
#include "adapters/nlu/parse/islands.hpp"

namespace parlour::adapters::nlu {

// While a question wants yes or no, "yes" and "no" are not values of slots.
// Otherwise they can be a value by themselves, of the slot that was asked for
// only. Removes the islands that say otherwise.
void prefer_answers(std::vector<Island>& islands, const Context& context);

// What an application means by words goes before what they mean anywhere:
// removes generic acts, other than yes and no, for the words of a rule of the
// application, and answers to what was asked that such a rule takes for another
// slot of the topic: "my name is …", where the host is asked for.
void prefer_application(std::vector<Island>& islands);

// Where a rule of the application says the very words that would be a time, a
// date or the like of the same topic, or by themselves, the rule is meant:
// "this afternoon" may be what a programme has.
void prefer_literals(std::vector<Island>& islands, const Spans& spans);

} // namespace parlour::adapters::nlu
