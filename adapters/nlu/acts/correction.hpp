// "No, I meant three": finds out which slot is corrected if the next question
// has been asked already.
#pragma once

#include "adapters/nlu/parse/built_act.hpp"

namespace parlour::adapters::nlu {

// A correction that would only fill the slot which is being asked for cannot
// correct that one, since it has no value yet. It corrects the slot that was
// filled last and that the words fit. A slot of any words fits only words that
// are no known value.
void correct_what_was_said(BuiltAct& act, const Spans& spans,
                           const Context& context);

// "My number is 91234567. Hang on, make it quarter past ten": what is said of a
// topic and corrected before anything was done is one act, so that nothing is
// done with the value that was corrected. Lists of values keep their own acts.
void join_corrections(std::vector<BuiltAct>& acts, const Schema& schema);

} // namespace parlour::adapters::nlu
