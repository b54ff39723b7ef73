#include "script/dialogue/topic_engine/yes_or_no_outcome.hpp"

#include <memory>
#include <utility>
#include <vector>

namespace parlour::dialogue {

// Each purpose of a question of yes or no has its own effect. The default is a
// script's <confirm>.
void YesOrNoOutcome::answer(const Asked& asked, const Act& act, TurnId turn) {
  const bool yes = act.kind == ActKind::confirm;
  switch (asked.purpose) {
  case Asked::For::truth:
    fill_slot(asked, act, turn);
    return;
  case Asked::For::more:
    close_or_reopen(asked, yes, turn);
    return;
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

// A yes or no is the slot's value (cardinality `boolean`). It becomes an act
// that names the slot, so that constraints, grounding and <filled> follow as
// for any other value.
void YesOrNoOutcome::fill_slot(const Asked& asked, const Act& act,
                               TurnId turn) {
  SlotValue said;
  said.slot = context_.topic(asked.topic).slots[asked.slot].name;
  said.value = act.kind == ActKind::confirm;
  said.confidence = act.confidence;
  said.text = act.text;
  auto inform = std::make_shared<Act>();
  inform->topic = context_.topic(asked.topic).name;
  inform->kind = ActKind::inform;
  inform->confidence = act.confidence;
  inform->elliptical = true; // an answer, no sentence that says all
  inform->text = act.text;
  inform->slots.push_back(std::move(said));
  filling_.take({asked.topic, turn, std::move(inform)});
}

// "Anything else?" A no closes the list of values. A yes says no value, so the
// next wording of the question comes (engine rule 5.14).
void YesOrNoOutcome::close_or_reopen(const Asked& asked, bool yes,
                                     TurnId turn) {
  FrameChange change;
  change.kind = yes ? FrameChange::Kind::reopen : FrameChange::Kind::close;
  change.slot = asked.slot;
  std::vector<FrameChange> changes{std::move(change)};
  filling_.request({.topic = asked.topic, .turn = turn}, changes);
}

// The earlier value must be noted before the request: when the frame has come
// back, it is the slot's value and no longer known as the earlier one.
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

// "Shall we go on with the taxi?" "No." ends the topic; it would be offered
// again after each silence otherwise.
void YesOrNoOutcome::answer_resume(TopicId topic, bool yes, TurnId turn) {
  if (yes) {
    topic_changes_.take_up(topic);
    return;
  }
  context_.lane.at_once(steps::CancelTopic{topic, turn});
}

} // namespace parlour::dialogue
