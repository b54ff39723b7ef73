// YesOrNo: answers to questions of yes or no: a script's <confirm>, a value in
// doubt, whether to go on with a topic (engine rule 5, language rule 12.20).
// What cannot be taken back is never done on an unsure reading: where a yes
// could be for something else, or could be a no, it is asked again.
#pragma once

#include "script/dialogue/agenda/step_list.hpp"
#include "script/dialogue/context/dialogue_context.hpp"
#include "script/dialogue/context/open_question.hpp"
#include "script/dialogue/questions/confirmations.hpp"
#include "script/dialogue/questions/reprompts.hpp"
#include "script/dialogue/topic_engine/breath.hpp"
#include "script/dialogue/topic_engine/course/topic_changes.hpp"
#include "script/dialogue/topic_engine/said_beside.hpp"
#include "script/dialogue/topic_engine/yes_or_no_outcome.hpp"

namespace parlour::dialogue {

// The first half of engine rule 5.8: whether what was said answers the
// question. What the answer leads to is YesOrNoOutcome's. ActEntry and
// TopicActs call it. It keeps nothing: an answer that has to wait is Breath's.
class YesOrNo {
public:
  YesOrNo(DialogueContext& context, OpenQuestion& question,
          Confirmations& confirmations, Reprompts& reprompts,
          TopicChanges& topic_changes, Breath& breath, SaidBeside& beside,
          YesOrNoOutcome& outcome)
      : context_(context), question_(question), confirmations_(confirmations),
        reprompts_(reprompts), topic_changes_(topic_changes), breath_(breath),
        beside_(beside), outcome_(outcome) {}

  // Whether the act is a yes or no, and is dealt with: for a <confirm> of the
  // topic that it names, else for the question that was heard last. False: the
  // act goes its usual way. "Dealt with" includes that the question is asked
  // again, and that the act is dropped because it came before the question.
  bool answer_to_question(const ActPointer& act, TurnId turn);
  // The <confirm> that others were put in front of is asked again.
  void take(const steps::AskConfirm& step);

private:
  // True where a <confirm> waits at all.
  bool ask_confirm_again();
  // The question was heard, and waits for this.
  void read_answer(const ActPointer& act, TurnId turn);

  DialogueContext& context_;
  OpenQuestion& question_;
  Confirmations& confirmations_;
  Reprompts& reprompts_;
  TopicChanges& topic_changes_;
  Breath& breath_;
  SaidBeside& beside_;
  YesOrNoOutcome& outcome_;
};

} // namespace parlour::dialogue
