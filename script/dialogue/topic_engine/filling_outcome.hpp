// FillingOutcome: what became of an act's values leads to rules and to the
// slots' own actions (engine rule 5).
#pragma once

#include "script/dialogue/agenda/step_list.hpp"
#include "script/dialogue/context/dialogue_context.hpp"
#include "script/dialogue/context/open_question.hpp"
#include "script/dialogue/context/text_evaluator.hpp"
#include "script/dialogue/context/topic_frames.hpp"
#include "script/dialogue/questions/reprompts.hpp"
#include "script/dialogue/questions/topic_words.hpp"
#include "script/dialogue/topic_engine/confirm_answers.hpp"
#include "script/dialogue/topic_engine/settling.hpp"

namespace parlour::dialogue {

class FillingOutcome {
public:
  FillingOutcome(DialogueContext& context, TextEvaluator& texts,
                 TopicFrames& frames, TopicWords& words, OpenQuestion& question,
                 Reprompts& reprompts, Settling& settling,
                 ConfirmAnswers& confirm_answers)
      : context_(context), texts_(texts), frames_(frames), words_(words),
        question_(question), reprompts_(reprompts), settling_(settling),
        confirm_answers_(confirm_answers) {}

  // Rules, then a report for each slot that leads on, then settle.
  void filled(const steps::Fill& step, ResultPointer result);
  void take(const steps::Rule& step);
  void take(const steps::Report& step);

private:
  Value refusal(TopicId topic, const SlotReport& report);

  DialogueContext& context_;
  TextEvaluator& texts_;
  TopicFrames& frames_;
  TopicWords& words_;
  OpenQuestion& question_;
  Reprompts& reprompts_;
  Settling& settling_;
  ConfirmAnswers& confirm_answers_;
};

} // namespace parlour::dialogue
