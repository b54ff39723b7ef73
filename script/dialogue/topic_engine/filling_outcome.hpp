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
#include "script/dialogue/topic_engine/course/settling.hpp"

namespace parlour::dialogue {

// Steps 5 and 6 of engine rule 5.4. Filling gives it the result, the lane the
// steps that come of it. Each piece of script is a step, so that one that waits
// holds back those behind it. It keeps nothing.
class FillingOutcome {
public:
  FillingOutcome(DialogueContext& context, TextEvaluator& texts,
                 TopicFrames& frames, TopicWords& words, OpenQuestion& question,
                 Reprompts& reprompts, Settling& settling,
                 ConfirmAnswers& confirm_answers)
      : context_(context), texts_(texts), frames_(frames), words_(words),
        question_(question), reprompts_(reprompts), settling_(settling),
        confirm_answers_(confirm_answers) {}

  // Rules, then a report for each slot that leads on, then settle. The frame
  // that `result` is about must be the topic's already.
  void filled(const steps::Fill& step, ResultPointer result);
  // The condition is computed here, not when the step was made: an earlier rule
  // may have changed what it reads.
  void take(const steps::Rule& step);
  void take(const steps::Report& step);

private:
  // The data of the phrase `invalid`.
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
