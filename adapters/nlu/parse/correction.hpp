// "No, I meant three": which slot a correction is of, where the next question
// waits already.
#pragma once

#include "adapters/nlu/parse/acts.hpp"

namespace parlour::adapters::nlu {

// What would only fill the slot that is asked for, which has nothing to
// correct, is of a slot that was said before: of the last that it fits. Any
// words fit a slot that takes any, unless they fit what is asked.
void correct_what_was_said(BuiltAct& act, const Spans& spans,
                           const Context& context);

} // namespace parlour::adapters::nlu
