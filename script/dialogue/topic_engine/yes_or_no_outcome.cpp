#include "script/dialogue/topic_engine/yes_or_no_outcome.hpp"

#include <utility>
#include <vector>

namespace parlour::dialogue {

void YesOrNoOutcome::answer(const Asked& asked, bool yes, TurnId turn) {
  switch (asked.purpose) {
  case Asked::For::confirmation:
    confirm_slot(asked.topic, asked.slot, yes, turn);
    return;
  case Asked::For::resume:
    answer_resume(asked.topic, yes, turn);
    return;
  default:
    confirm_answers_.answer_confirm(asked, yes);
  }
}

void YesOrNoOutcome::confirm_slot(TopicId topic, SlotId slot, bool yes,
                                  TurnId turn) {
  FrameChange change;
  change.kind =
      yes ? FrameChange::Kind::confirmed : FrameChange::Kind::disconfirmed;
  change.slot = slot;
  if (!yes)
    refusals_.doubt_earlier_value(topic, slot);
  std::vector<FrameChange> changes{std::move(change)};
  filling_.request({.topic = topic, .turn = turn}, changes);
}

void YesOrNoOutcome::answer_resume(TopicId topic, bool yes, TurnId turn) {
  if (yes) {
    topic_changes_.take_up(topic);
    return;
  }
  context_.lane.at_once(steps::CancelTopic{topic, turn});
}

} // namespace parlour::dialogue
