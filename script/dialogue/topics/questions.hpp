// Questions: which wording asks for a slot, and what to do when an answer does
// not come or is not understood (engine rule 5). Pure.
#pragma once

#include <vector>

#include "script/dialogue/frame/topic_frame.hpp"
#include "script/program/program.hpp"

namespace parlour::dialogue {

// Whether it is asked for further values of the slot now ("Anything else?").
// Not after a yes to that: then the next wording asks which (engine rule 5.14).
bool asks_for_more(const script::Slot& slot, const SlotState& state);

// The slot's question the first time, then its <help> wordings in turn; no_code
// where the slot has no words at all. The first time is `state.asked` 0: how
// often its question was released.
CodeId question_wording(const script::Slot& slot, const SlotState& state);

// The next of the <explain> texts; no_code where there is none.
CodeId explain_wording(const script::Slot& slot, const SlotState& state);

// The <noinput> or <nomatch> that is due: each holds from its count on, until
// the next higher one; no_code before the first.
CodeId counted_body(const std::vector<script::CountedBody>& bodies,
                    std::uint32_t count);

} // namespace parlour::dialogue
