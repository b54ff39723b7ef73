#include "script/dialogue/topic_engine/topic_acts.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include "script/dialogue/topics/classifier.hpp"
#include "script/dialogue/topics/misnamed.hpp"

namespace parlour::dialogue {

namespace {

// Whether the utterance has further acts. "Yes. The first one." is no
// misunderstanding: the second act may name what the first leaves open.
bool says_more(const DialogueContext& context) {
  const auto& ahead = context.lane.ahead();
  return std::any_of(ahead.begin(), ahead.end(), is<steps::TakeAct>);
}

} // namespace

// The steps of engine rule 5.3, in its order. An act that answers a question is
// gone before its topic is looked for. Acts are shared, so a step that changes
// one makes a copy.
void TopicActs::take(steps::TopicAct&& step) {
  if (offers_.was_consumed(step.offer))
    return;
  // Who was offered it might have known the name.
  if (const auto error = misnamed(*context_.program, *step.act)) {
    messenger_.script_failed(*error, step.turn);
    return;
  }
  if (yes_or_no_.answer_to_question(step.act, step.turn))
    return;
  if (clarification_.leaves_open_which(*step.act)) {
    if (!says_more(context_))
      reprompts_.misunderstood(step.turn, step.act->text);
    return;
  }
  if (names_slot(*step.act)) {
    take_name_of_slot(step);
    return;
  }
  clarification_.complete_by_answer(step);
  prefer_reading(step);
  if (!take_about_conversation(step))
    find_topic(std::move(step));
}

// "How about food court?", after an enquiry about coffee shops.
void TopicActs::prefer_reading(steps::TopicAct& step) const {
  if (step.act->alternatives.empty())
    return;
  auto act = *step.act;
  if (act.elliptical)
    prefer_resting(*context_.program, act, whereabouts_.classifier_context());
  prefer_known(act);
  step.act = std::make_shared<const Act>(std::move(act));
}

// "Help" in the middle of a topic is about the conversation. "Help" with a
// topic named is about that one; only "cancel" and "abandon" may name what they
// end.
bool TopicActs::take_about_conversation(const steps::TopicAct& step) {
  const auto& act = *step.act;
  const auto named = context_.program->topic(act.topic);
  if (is_generic(act) && (named == script::no_id || wants_out(act))) {
    repair_acts_.generic_act(step, named, late_corrections_.taken_back());
    return true;
  }
  const auto late = late_corrections_.take(step);
  if (late == LateCorrections::Outcome::says_again)
    acknowledge(step.turn);
  return late != LateCorrections::Outcome::no_concern;
}

// Only where it was asked what is wrong. The value stays until there is another
// one. The question whether all is right is asked again when the topic settles.
void TopicActs::take_name_of_slot(const steps::TopicAct& step) {
  const auto& act = *step.act;
  const auto topic = context_.program->topic(act.topic);
  if (!question_ || !question_->asks_for_changes() ||
      question_->topic != topic) {
    reprompts_.misunderstood(step.turn, act.text);
    return;
  }
  repairs_.understood();
  question_.take();
  reprompts_.ask_slot(topic, context_.topic(topic).slot(act.slots[0].slot),
                      OutputAct::question, step.turn);
}

// The rest of the utterance gets an answer of its own.
void TopicActs::acknowledge(TurnId turn) {
  repairs_.understood();
  if (!says_more(context_))
    words_.say("acknowledge", script::no_id, script::no_id, {}, turn);
}

// A bare yes or no begins no topic. Where nothing is asked, it is acknowledged,
// as people say "ok" to what they were told. After "What should I change?" it
// changes nothing, so the topic settles again, which asks for the whole once
// more (engine rule 5.13). To any other question it is not understood. Who does
// not want something of a topic that nobody speaks of ("not the wheelchair") is
// acknowledged, too.
void TopicActs::find_topic(steps::TopicAct&& step) {
  const auto& act = *step.act;
  if (is_answer(act) && !question_) { // "ok", and nobody had asked
    acknowledge(step.turn);
    return;
  }
  if (is_answer(act) && question_->purpose == Asked::For::change) {
    context_.lane.at_once(steps::Settle{question_.take().topic, step.turn});
    return;
  }
  const auto topic = whereabouts_.topic_of(act);
  const bool says_nothing =
      act.topic.empty() && act.slots.empty() && !act.elliptical;
  if (topic == script::no_id || says_nothing || is_answer(act)) {
    reprompts_.misunderstood(step.turn, act.text);
    return;
  }
  if (act.kind == ActKind::deny && !whereabouts_.goes_on(topic)) {
    acknowledge(step.turn);
    return;
  }
  repairs_.understood();
  steps::Fill fill{topic, step.turn, std::move(step.act)};
  if (!clarification_.ask_which(fill))
    delivery_.give_to_topic(std::move(fill));
}

} // namespace parlour::dialogue
