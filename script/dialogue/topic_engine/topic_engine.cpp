#include "script/dialogue/topic_engine/topic_engine.hpp"

namespace parlour::dialogue {

TopicEngine::TopicEngine(DialogueContext& context, Messenger& messenger,
                         TopicFrames& frames, ActivationRunner& runner,
                         const Reactions& reactions, OpenQuestion& question,
                         OutputManager& output)
    : frames_(frames), offers_(context, reactions),
      words_(context, frames, runner, output),
      asking_(context, output, frames, words_, question),
      confirmations_(context, frames, runner, question, asking_),
      whereabouts_(context, frames, question, confirmations_),
      clarification_(context, question, asking_, whereabouts_),
      repairs_(context, frames, runner, words_, question, whereabouts_),
      reprompts_(context, runner, offers_, frames, words_, question, asking_,
                 clarification_, repairs_),
      next_question_(context, output, frames, words_, question, confirmations_,
                     reprompts_),
      refusals_(context, runner, output, frames, confirmations_),
      changes_(context, frames, question, asking_, confirmations_),
      enquiries_(context, messenger, output, frames, words_, refusals_,
                 changes_),
      settling_(context, runner, frames, question, confirmations_, refusals_,
                changes_, enquiries_),
      confirm_answers_(context, frames, confirmations_, refusals_, changes_),
      outcome_(context, runner, frames, words_, question, reprompts_, settling_,
               confirm_answers_),
      filling_(context, messenger, frames, confirmations_, whereabouts_,
               next_question_, outcome_),
      breath_(context, question),
      beside_(context, frames, question, whereabouts_),
      yes_or_no_outcome_(context, refusals_, changes_, confirm_answers_,
                         filling_),
      yes_or_no_(context, question, confirmations_, reprompts_, changes_,
                 breath_, beside_, yes_or_no_outcome_),
      silence_(context, frames, runner, offers_, question, asking_,
               confirmations_, reprompts_, next_question_, changes_),
      ends_(context, frames, words_, question, asking_, confirmations_,
            whereabouts_),
      repair_acts_(question, repairs_, reprompts_, breath_, ends_),
      late_corrections_(context, frames, confirmations_, repairs_, changes_,
                        settling_),
      delivery_(context, frames, words_, question, confirmations_, changes_,
                filling_),
      acts_(context, messenger, offers_, words_, question, whereabouts_,
            clarification_, repairs_, reprompts_, yes_or_no_, repair_acts_,
            late_corrections_, delivery_),
      entry_(context, offers_, question, confirmations_, reprompts_,
             next_question_, breath_, yes_or_no_, silence_, acts_) {}

void TopicEngine::restart() {
  asking_.withdraw();
  changes_.forget();
  whereabouts_.forget();
  enquiries_.forget();
  silence_.user_spoke();
  repairs_.understood();
  frames_.restart();
}

} // namespace parlour::dialogue
