#include "script/dialogue/topic_engine/topic_engine.hpp"

namespace parlour::dialogue {

TopicEngine::TopicEngine(DialogueContext& context, Messenger& messenger,
                         TopicFrames& frames, ActivationRunner& runner,
                         Waits& waits, const Reactions& reactions,
                         OutputManager& output, PushedStates& pushed_states)
    : frames_(frames), offers_(context, reactions),
      words_(context, frames, runner, output),
      question_(context, output, frames, words_),
      confirmations_(context, frames, runner, waits, question_),
      whereabouts_(context, frames, question_, confirmations_),
      clarification_(context, question_, whereabouts_),
      repairs_(context, frames, runner, words_, question_, whereabouts_),
      reprompts_(context, runner, offers_, frames, words_, question_,
                 clarification_, repairs_),
      next_question_(context, output, pushed_states, frames, words_, question_,
                     confirmations_, reprompts_),
      refusals_(context, runner, output, frames, confirmations_),
      changes_(context, frames, question_, confirmations_),
      enquiries_(context, messenger, output, frames, words_, refusals_,
                 changes_),
      settling_(context, runner, frames, question_, confirmations_, refusals_,
                changes_, enquiries_),
      confirm_answers_(context, waits, frames, confirmations_, refusals_,
                       changes_),
      outcome_(context, runner, frames, words_, question_, reprompts_,
               settling_, confirm_answers_),
      filling_(context, messenger, frames, confirmations_, whereabouts_,
               next_question_, outcome_),
      breath_(context, question_),
      beside_(context, frames, question_, whereabouts_),
      yes_or_no_outcome_(context, refusals_, changes_, confirm_answers_,
                         filling_),
      yes_or_no_(context, question_, confirmations_, reprompts_, changes_,
                 breath_, beside_, yes_or_no_outcome_),
      silence_(context, frames, runner, offers_, question_, confirmations_,
               reprompts_, next_question_, changes_),
      wait_ends_(waits, confirmations_, refusals_, enquiries_),
      ends_(context, pushed_states, frames, words_, question_, confirmations_,
            whereabouts_, wait_ends_),
      repair_acts_(question_, repairs_, reprompts_, breath_, ends_),
      late_corrections_(context, frames, confirmations_, repairs_, changes_,
                        settling_),
      delivery_(context, frames, words_, question_, confirmations_, changes_,
                filling_),
      acts_(context, messenger, offers_, words_, question_, whereabouts_,
            clarification_, repairs_, reprompts_, yes_or_no_, repair_acts_,
            late_corrections_, delivery_),
      entry_(context, offers_, question_, confirmations_, reprompts_,
             next_question_, breath_, yes_or_no_, silence_, acts_) {}

void TopicEngine::restart() {
  question_.withdraw();
  changes_.forget();
  whereabouts_.forget();
  enquiries_.forget();
  silence_.user_spoke();
  repairs_.understood();
  frames_.restart();
}

} // namespace parlour::dialogue
