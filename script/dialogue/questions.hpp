// Questions: which wording asks for a slot, and what to do when an answer does
// not come or is not understood (engine rule 5). Pure.
#pragma once

#include <vector>

#include "script/dialogue/frame.hpp"
#include "script/program.hpp"

namespace parlour::dialogue {

// The slot's question the first time, then its <help> wordings in turn;
// no_code where the slot has no words at all.
CodeId question_wording(const script::Slot& slot, const SlotState& state);

// The next of the <explain> texts; no_code where there is none.
CodeId explain_wording(const script::Slot& slot, const SlotState& state);

// The <noinput> or <nomatch> that is due: each holds from its count on, until
// the next higher one; no_code before the first, where the ladder applies.
CodeId counted_body(const std::vector<script::CountedBody>& bodies,
                    std::uint32_t count);

// clang-format off
#define PARLOUR_LADDER_STEPS(X) \
  X(repeat, "the same words again") X(rephrase, "another wording") \
  X(explain, "why it is asked") X(offer_choices, "what can be answered") \
  X(offer_person, "somebody to talk to")
// clang-format on

// The standard ladder, in order of failures; the last step stays.
enum class LadderStep : std::uint8_t {
#define X(name, sentence) name,
  PARLOUR_LADDER_STEPS(X)
#undef X
};

std::string_view name_of(LadderStep step);

// `count` failures in a row, from 1.
LadderStep ladder_step(std::uint32_t count);

// The same, with steps that the slot has nothing for (no explanation, no
// choices) replaced by another wording of the question.
LadderStep ladder_step(const script::Slot& slot, std::uint32_t count);

} // namespace parlour::dialogue
