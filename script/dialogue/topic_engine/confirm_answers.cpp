#include "script/dialogue/topic_engine/confirm_answers.hpp"

#include <algorithm>
#include <utility>

namespace parlour::dialogue {

// The refusal is noted before the slot is emptied: it remembers the slot's
// value. A topic that was suspended becomes the current one before its script
// goes on: a wait of the dialogue lane that is woken comes when the running
// agenda is done. A handler's <confirm> has no topic to go back to.
void ConfirmAnswers::answer_confirm(const Asked& asked, bool yes) {
  if (!yes)
    refusals_.note_no(asked.topic, asked.body);
  settle_confirmed(asked, yes);
  confirmations_.wait_is_over(asked.wait);
  context_.lane.now(topic_changes_.back_to(asked.topic));
  if (yes)
    confirmations_.back_to_question_before(asked);
  auto goes_on = outcome_step(asked.wait, Value(yes));
  if (context_.lane.waits(asked.wait))
    context_.lane.wake(asked.wait, std::move(goes_on));
  else // it waits in the pipeline lane
    context_.lane.now(std::move(goes_on));
}

// A <confirm slot>: yes accepts the slot's value, no empties the slot, before
// <yes> or <no> runs.
void ConfirmAnswers::settle_confirmed(const Asked& asked, bool yes) {
  if (asked.about != script::no_id)
    frames_.change(asked.topic, {.kind = yes ? FrameChange::Kind::confirmed
                                             : FrameChange::Kind::clear,
                                 .slot = asked.about});
}

void ConfirmAnswers::heed_denial(TopicId topic, SlotId slot) {
  const auto body = context_.topic(topic).slots[slot].filled;
  const auto found =
      std::ranges::find_if(confirmations_.all(), [&](const Asked& confirm) {
        return confirm.topic == topic && confirm.body == body && !confirm.anew;
      });
  if (found == confirmations_.all().end())
    return;
  const auto asked = *found;
  confirmations_.forget_question(asked);
  answer_confirm(asked, false);
}

} // namespace parlour::dialogue
