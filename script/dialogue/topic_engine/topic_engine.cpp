#include "script/dialogue/topic_engine/topic_engine.hpp"

namespace parlour::dialogue {

TopicEngine::TopicEngine(DialogueContext& context, Messenger& messenger,
                         TopicFrames& frames, RunningScript& running,
                         TextEvaluator& texts, const ActivationRunner& runner,
                         OpenQuestion& question, OutputManager& output,
                         QuestionParts& questions)
    : frames_(frames), questions_(questions),
      refusals_(context, running, output, frames, questions.confirmations),
      changes_(context, frames, question, questions.asking,
               questions.confirmations),
      enquiries_(context, messenger, output, frames, questions.words, refusals_,
                 changes_),
      settling_(context, running, frames, question, questions.confirmations,
                refusals_, changes_, enquiries_),
      confirm_answers_(context, frames, questions.confirmations, refusals_,
                       changes_),
      outcome_(context, texts, frames, questions.words, question,
               questions.reprompts, settling_, confirm_answers_),
      filling_(context, messenger, frames, questions.confirmations,
               questions.whereabouts, questions.next_question, outcome_),
      breath_(context, question),
      beside_(context, frames, question, questions.whereabouts),
      yes_or_no_outcome_(context, refusals_, changes_, confirm_answers_,
                         filling_),
      yes_or_no_(context, question, questions.confirmations,
                 questions.reprompts, changes_, breath_, beside_,
                 yes_or_no_outcome_),
      silence_(context, frames, runner, questions.offers, question,
               questions.asking, questions.confirmations, questions.reprompts,
               questions.next_question, changes_),
      ends_(context, frames, questions.words, question, questions.asking,
            questions.confirmations, questions.whereabouts),
      repair_acts_(question, questions.repairs, questions.reprompts, breath_,
                   ends_),
      late_corrections_(context, frames, questions.confirmations,
                        questions.repairs, changes_, settling_),
      delivery_(context, frames, questions.words, question,
                questions.confirmations, changes_, filling_),
      acts_(context, messenger, questions.offers, questions.words, question,
            questions.whereabouts, questions.clarification, questions.repairs,
            questions.reprompts, yes_or_no_, repair_acts_, late_corrections_,
            delivery_),
      entry_(context, questions.offers, question, questions.confirmations,
             questions.reprompts, questions.next_question, breath_, yes_or_no_,
             silence_, acts_) {}

void TopicEngine::restart() {
  questions_.asking.withdraw();
  changes_.forget();
  questions_.whereabouts.forget();
  enquiries_.forget();
  silence_.user_spoke();
  questions_.repairs.understood();
  frames_.restart();
}

} // namespace parlour::dialogue
