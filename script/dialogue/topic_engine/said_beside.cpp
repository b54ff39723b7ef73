#include "script/dialogue/topic_engine/said_beside.hpp"

#include <algorithm>
#include <variant>

#include "script/dialogue/agenda/step_list.hpp"
#include "script/dialogue/topics/classifier.hpp"

namespace parlour::dialogue {

namespace {

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

// What is no wish of its own beside a yes or no: "yes, yes", "yes, sorry", "yes
// … well". Whether it contradicts is another question.
bool is_further_answer(const Act& act) {
  return is_answer(act) || takes_back(act) || says_nothing(act);
}

bool is_wish(const Step& step) {
  const auto* taken = std::get_if<steps::TakeAct>(&step);
  return taken && !is_courtesy(*taken->act);
}

} // namespace

bool has_wish(const StepList& ahead) {
  return std::ranges::any_of(ahead, is_wish);
}

SaidBeside::Reading SaidBeside::read(const Act& answer) {
  const auto reading = judge(answer);
  drop(is_further_answer);
  return reading;
}

// After a no, a value of the topic is always a wish: "no, three nights" fills
// the slot, and the question is made anew. After a yes it is one only where it
// differs from what the topic has. An act about another topic does not hinder
// the answer; set_wishes_aside() keeps it for later.
SaidBeside::Reading SaidBeside::judge(const Act& answer) const {
  Reading reading;
  const bool yes = answer.kind == ActKind::confirm;
  for (const auto& other : context_.lane.ahead()) {
    const auto* taken = std::get_if<steps::TakeAct>(&other);
    if (!taken)
      continue;
    const auto& act = *taken->act;
    if (is_further_answer(act))
      reading.contradicts |= act.kind != answer.kind;
    else if (is_generic(act))
      reading.wishes |= !is_courtesy(act) && !echoes(act);
    else
      reading.wishes |= is_about_it(act) && !(yes && says_the_same(act));
  }
  return reading;
}

void SaidBeside::drop_echoes() {
  drop([&](const Act& other) { return echoes(other) || is_about_it(other); });
}

// Such acts become the lane's next item: the answer may end the topic or leave
// the state, and what is to be done about them is decided after that.
void SaidBeside::set_wishes_aside() {
  if (has_wish(context_.lane.ahead()))
    context_.lane.set_acts_aside(); // which would leave what is asked about
}

void SaidBeside::drop(const std::function<bool(const Act&)>& wanted) {
  const auto dropped = context_.lane.take_ahead([&](const Step& step) {
    const auto* taken = std::get_if<steps::TakeAct>(&step);
    return taken && wanted(*taken->act);
  });
  for (const auto& step : dropped)
    context_.turns.let_go(turn_of(step));
}

// "Shall I really cancel it?" "Yes, cancel it."
bool SaidBeside::echoes(const Act& act) const {
  const auto& repairs = context_.program->repairs;
  return std::ranges::any_of(repairs, [&](const script::Repair& repair) {
    return question_->body != script::no_code &&
           repair.body == question_->body && repair.act == name_of(act.kind);
  });
}

bool SaidBeside::is_about_it(const Act& act) const {
  return question_->topic != script::no_id && !is_generic(act) &&
         classify(*context_.program, act, whereabouts_.classifier_context()) ==
             question_->topic;
}

// "Two nights?" "Yes, two nights."
bool SaidBeside::says_the_same(const Act& act) const {
  const auto& topic = context_.topic(question_->topic);
  const auto& slots = frames_[question_->topic].slots;
  return std::ranges::all_of(act.slots, [&](const SlotValue& said) {
    const auto slot = topic.slot(said.slot);
    return act.kind != ActKind::deny && slot != script::no_id &&
           !said.value.is_unknown() && slots[slot].value == said.value;
  });
}

} // namespace parlour::dialogue
