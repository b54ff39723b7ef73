// The part of the topic engine for acts that are about the conversation
// itself: help, repeat, cancel, start over, greetings and goodbye.
#include <utility>

#include "script/dialogue/core.hpp"
#include "script/dialogue/questions.hpp"
#include "script/dialogue/steps.hpp"

namespace parlour::dialogue {

bool TopicEngine::is_generic(const Act& act) const {
  switch (act.kind) {
  case ActKind::inform:
  case ActKind::request:
  case ActKind::correct:
    return false;
  case ActKind::confirm:
  case ActKind::deny:
    return false; // for a slot, or to no question: not understood
  default:
    return act.slots.empty();
  }
}

void TopicEngine::generic_act(const Step& step) {
  const auto turn = step.turn;
  switch (step.act.kind) {
  case ActKind::help:
    help(turn);
    return;
  case ActKind::repeat:
    if (core_.mouth.said_anything())
      core_.mouth.repeat_last(turn);
    else
      say("repeat_nothing", script::no_id, script::no_id, {}, turn);
    return;
  case ActKind::cancel:
    cancel(turn);
    return;
  case ActKind::restart:
    say("restarted", script::no_id, script::no_id, {}, turn);
    core_.lane.queue({topic_step(StepKind::restart, script::no_id)});
    return;
  case ActKind::bye:
    say("bye", script::no_id, script::no_id,
        Map{{"unfinished", unfinished_names()}}, turn);
    core_.lane.now({topic_step(StepKind::end, script::no_id)});
    return;
  case ActKind::greet:
  case ActKind::thank:
    say(std::string(name_of(step.act.kind)).c_str(), script::no_id,
        script::no_id, {}, turn);
    return;
  default:
    return;
  }
}

// "help" to a question: why it is asked, then the question again.
void TopicEngine::help(TurnId turn) {
  if (!asked_ || !asked_->heard || asked_->slot == script::no_id) {
    say("help", script::no_id, script::no_id, {}, turn);
    return;
  }
  const auto topic = asked_->topic;
  const auto slot = asked_->slot;
  auto text = text_of(explain_wording(core_.topic(topic).slots[slot],
                                      core_.frame(topic).slots[slot]),
                      topic);
  if (text.empty())
    say("help", topic, slot, choices_of(topic, slot), turn);
  else
    say_text(std::move(text), turn);
  ask_slot(topic, slot, OutputAct::reprompt, turn);
}

// What waits is ended first, so that a <catch> still sees its topic.
void TopicEngine::cancel(TurnId turn) {
  auto topic = asked_ && asked_->topic != script::no_id
                   ? asked_->topic
                   : core_.order.current().value_or(script::no_id);
  if (topic == script::no_id && !core_.order.suspended().empty())
    topic = core_.order.suspended().front();
  auto steps = core_.cancel_waits();
  core_.machine.clear_pushed();
  asked_.reset();
  if (topic == script::no_id) {
    say("cancelled", script::no_id, script::no_id, {}, turn);
  } else {
    auto step = topic_step(StepKind::cancel_topic, topic);
    step.turn = turn;
    steps.push_back(std::move(step));
  }
  core_.lane.now(std::move(steps));
}

void TopicEngine::forget_waits() {
  if (asked_ && asked_->purpose == Asked::For::yes_or_no)
    asked_.reset();
  confirms_.clear();
  query_.reset();
}

List TopicEngine::unfinished_names() const {
  List names;
  for (auto topic : core_.order.suspended())
    names.emplace_back(core_.topic(topic).name);
  if (auto current = core_.order.current();
      current && core_.order.unfinished(*current))
    names.insert(names.begin(), core_.topic(*current).name);
  return names;
}

void TopicEngine::restart() {
  core_.mouth.withdraw_questions();
  asked_.reset();
  query_.reset();
  no_input_ = 0;
  for (TopicId topic = 0; topic < core_.program->topics.size(); ++topic)
    if (core_.frame(topic).status != TopicStatus::untouched)
      change(topic, {.kind = FrameChange::Kind::reset});
  core_.order = TopicOrder(*core_.program);
}

} // namespace parlour::dialogue
