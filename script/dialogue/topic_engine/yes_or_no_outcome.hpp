// YesOrNoOutcome: what a yes or no leads to: a value in doubt is accepted or
// taken back, a topic goes on or is cancelled, a script goes on (engine rule
// 5.8).
#pragma once

#include "script/dialogue/context/asked.hpp"
#include "script/dialogue/context/dialogue_context.hpp"
#include "script/dialogue/topic_engine/confirm_answers.hpp"
#include "script/dialogue/topic_engine/course/refusals.hpp"
#include "script/dialogue/topic_engine/course/topic_changes.hpp"
#include "script/dialogue/topic_engine/filling.hpp"

namespace parlour::dialogue {

// The second half of engine rule 5.8. The question has been taken from
// OpenQuestion already, so that what follows may ask the next one. It keeps
// nothing.
class YesOrNoOutcome {
public:
  YesOrNoOutcome(DialogueContext& context, Refusals& refusals,
                 TopicChanges& topic_changes, ConfirmAnswers& confirm_answers,
                 Filling& filling)
      : context_(context), refusals_(refusals), topic_changes_(topic_changes),
        confirm_answers_(confirm_answers), filling_(filling) {}

  // `act` is a yes or a no without slots, and answers `asked`, whose purpose is
  // one that wants a yes or no.
  void answer(const Asked& asked, const Act& act, TurnId turn);

private:
  void fill_slot(const Asked& asked, const Act& act, TurnId turn);
  void close_or_reopen(const Asked& asked, bool yes, TurnId turn);
  void confirm_slot(TopicId topic, SlotId slot, bool yes, TurnId turn);
  void answer_resume(TopicId topic, bool yes, TurnId turn);

  DialogueContext& context_;
  Refusals& refusals_;
  TopicChanges& topic_changes_;
  ConfirmAnswers& confirm_answers_;
  Filling& filling_;
};

} // namespace parlour::dialogue
