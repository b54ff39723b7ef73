// The part of the topic engine for answers to questions of yes or no: a
// script's <confirm>, a value in doubt, whether to go on with a topic (engine
// rule 5, language rule 12.20). What cannot be taken back is never done on an
// unsure reading: where a yes could be for something else, or could be a no, it
// is asked again.
#include <algorithm>
#include <iterator>
#include <sstream>
#include <utility>

#include "script/dialogue/agenda/steps.hpp"
#include "script/dialogue/topic_engine/topic_engine.hpp"
#include "script/dialogue/topics/classifier.hpp"

namespace parlour::dialogue {

namespace {

bool is_answer(const Act& act) {
  return act.slots.empty() &&
         (act.kind == ActKind::confirm || act.kind == ActKind::deny);
}

// "sorry", "no, wait": takes back what was said before it.
bool takes_back(const Act& act) {
  return act.kind == ActKind::correct && act.slots.empty() && act.topic.empty();
}

bool says_nothing(const Act& act) {
  return act.kind == ActKind::inform && act.topic.empty() &&
         act.slots.empty() && !act.elliptical;
}

// Leaves a yes or no beside it as it is.
bool is_courtesy(const Act& act) {
  return act.kind == ActKind::greet || act.kind == ActKind::thank;
}

bool is_another_wish(const Step& step) {
  return step.kind == StepKind::take_act && !is_courtesy(*step.act);
}

std::size_t count_words(const std::string& text) {
  std::istringstream words(text);
  return static_cast<std::size_t>(
      std::distance(std::istream_iterator<std::string>(words), {}));
}

} // namespace

// -- not heard ----------------------------------------------------------------

// Whoever has not heard half of it does not know what he says yes to.
void TopicEngine::broken_off(const Output& output, const std::string& heard) {
  if (asked_ && asked_->output == output.id && asked_->wants_yes_or_no() &&
      2 * count_words(heard) < count_words(output.text))
    asked_->heard = false;
}

void TopicEngine::said_again(OutputId before, OutputId now) {
  if (!asked_ || asked_->output != before || asked_->heard)
    return;
  asked_->output = now;
  asked_->pending = true;
}

// -- answers ------------------------------------------------------------------

// A yes or no to the question that waits for one: a <confirm> of the topic
// that the act names, else the question that was heard last.
bool TopicEngine::answer_to_question(const Step& step) {
  if (!is_answer(*step.act))
    return false;
  prefer_named_confirm(context_.program->topic(step.act->topic));
  if (!asked_)
    return ask_confirm_again();
  if (!asked_->wants_yes_or_no())
    return false;
  const bool same_turn = step.turn != 0 && asked_->turn == step.turn;
  if (asked_->pending || same_turn) // it was said before the question
    return true;
  if (!asked_->heard || asked_->interrupted || !asked_here())
    repeat_question(step.turn);
  else
    read_answer(step);
  return true;
}

bool TopicEngine::asked_here() const {
  return asked_ && asked_->level == context_.states.levels().size();
}

void TopicEngine::prefer_named_confirm(TopicId topic) {
  if (topic == script::no_id || (asked_ && asked_->topic == topic))
    return;
  const auto named = std::find_if(
      confirms_.rbegin(), confirms_.rend(), [&](const Asked& confirm) {
        return confirm.topic == topic && !confirm.anew;
      });
  if (named != confirms_.rend())
    asked_ = *named;
}

// Others came in between: who says yes now may mean them.
bool TopicEngine::ask_confirm_again() {
  if (const auto* confirm = latest_confirm()) {
    auto steps = back_to(confirm->topic);
    steps.push_back(topic_step(StepKind::ask, confirm->topic));
    context_.lane.now(std::move(steps));
  }
  return !confirms_.empty();
}

// What the same utterance says besides decides whether it is an answer.
void TopicEngine::read_answer(const Step& step) {
  const auto beside = said_beside(step);
  drop_beside([](const Act& act) {
    return is_answer(act) || takes_back(act) || says_nothing(act);
  });
  if (beside.wishes) // it follows, and the question comes again
    return;
  if (beside.contradicts) {
    misunderstood(step);
    return;
  }
  drop_beside([&](const Act& act) { return echoes(act) || is_about_it(act); });
  if (waits_for_more(step))
    return;
  if (std::ranges::any_of(context_.lane.ahead(), is_another_wish))
    context_.lane.set_acts_aside(); // which would leave what is asked about
  take_answer(step.act->kind == ActKind::confirm, step.turn);
}

TopicEngine::Beside TopicEngine::said_beside(const Step& step) const {
  Beside beside;
  const bool yes = step.act->kind == ActKind::confirm;
  for (const auto& other : context_.lane.ahead()) {
    if (other.kind != StepKind::take_act)
      continue;
    const auto& act = *other.act;
    if (is_answer(act) || takes_back(act) || says_nothing(act))
      beside.contradicts |= act.kind != step.act->kind;
    else if (is_generic(act))
      beside.wishes |= !is_courtesy(act) && !echoes(act);
    else
      beside.wishes |= is_about_it(act) && !(yes && says_the_same(act));
  }
  return beside;
}

void TopicEngine::drop_beside(const std::function<bool(const Act&)>& wanted) {
  const auto dropped = context_.lane.take_ahead([&](const Step& step) {
    return step.kind == StepKind::take_act && wanted(*step.act);
  });
  for (const auto& step : dropped)
    context_.turns.let_go(step.turn);
}

// "Shall I really cancel it?" "Yes, cancel it."
bool TopicEngine::echoes(const Act& act) const {
  const auto& repairs = context_.program->repairs;
  return std::ranges::any_of(repairs, [&](const script::Repair& repair) {
    return asked_->body != script::no_code && repair.body == asked_->body &&
           repair.act == name_of(act.kind);
  });
}

bool TopicEngine::is_about_it(const Act& act) const {
  return asked_->topic != script::no_id && !is_generic(act) &&
         classify(*context_.program, act, classifier_context()) ==
             asked_->topic;
}

// "Two nights?" "Yes, two nights."
bool TopicEngine::says_the_same(const Act& act) const {
  const auto& topic = context_.topic(asked_->topic);
  const auto& slots = context_.frame(asked_->topic).slots;
  return std::ranges::all_of(act.slots, [&](const SlotValue& said) {
    const auto slot = topic.slot(said.slot);
    return act.kind != ActKind::deny && slot != script::no_id &&
           !said.value.is_unknown() && slots[slot].value == said.value;
  });
}

void TopicEngine::take_answer(bool yes, TurnId turn) {
  const auto asked = *std::exchange(asked_, {});
  switch (asked.purpose) {
  case Asked::For::confirmation:
    confirm_slot(asked.topic, asked.slot, yes, turn);
    return;
  case Asked::For::resume:
    answer_resume(asked.topic, yes, turn);
    return;
  default:
    answer_confirm(asked, yes);
  }
}

void TopicEngine::answer_confirm(const Asked& asked, bool yes) {
  if (!yes)
    note_refusal(asked.topic, asked.body, output_.told());
  settle_confirmed(asked, yes);
  wait_is_over(asked.wait);
  context_.lane.now(back_to(asked.topic));
  if (yes)
    back_to_question_before(asked);
  waits_.resume(asked.wait, Value(yes));
}

// A <confirm slot>: yes accepts the slot's value, no empties the slot, before
// <yes> or <no> runs.
void TopicEngine::settle_confirmed(const Asked& asked, bool yes) {
  if (asked.about != script::no_id)
    change(asked.topic, {.kind = yes ? FrameChange::Kind::confirmed
                                     : FrameChange::Kind::clear,
                         .slot = asked.about});
}

void TopicEngine::confirm_slot(TopicId topic, SlotId slot, bool yes,
                               TurnId turn) {
  FrameChange change;
  change.kind =
      yes ? FrameChange::Kind::confirmed : FrameChange::Kind::disconfirmed;
  change.slot = slot;
  Step step;
  step.topic = topic;
  step.turn = turn;
  if (!yes)
    doubt_earlier_value(topic, slot);
  std::vector<FrameChange> changes{std::move(change)};
  request(std::move(step), changes);
}

// The value that was there before comes back; but a topic that would be
// completed with it asks: the user has just wanted another one.
void TopicEngine::doubt_earlier_value(TopicId topic, SlotId slot) {
  const auto& state = context_.frame(topic).slots[slot];
  if (!context_.topic(topic).slots[slot].functional ||
      state.previous.is_unknown())
    return;
  Refusal refusal;
  refusal.topic = topic;
  refusal.slot = slot;
  refusal.value = state.previous;
  refusals_.push_back(std::move(refusal));
}

} // namespace parlour::dialogue
