// The part of the topic engine for what a filling event leads to (engine rule
// 5): the topic is done, must be looked up, or asks for what is in doubt.
#include <algorithm>
#include <utility>

#include "script/dialogue/agenda/steps.hpp"
#include "script/dialogue/topic_engine/topic_engine.hpp"

namespace parlour::dialogue {

namespace {

template <class Predicate>
bool any_report(const Step& step, Predicate holds) {
  return step.result && std::any_of(step.result->reports.begin(),
                                    step.result->reports.end(), holds);
}

bool refused_any(const Step& step) {
  return any_report(step, [](const SlotReport& report) {
    return report.outcome == SlotOutcome::refused ||
           report.outcome == SlotOutcome::rejected;
  });
}

// Something was asked for that there is not: to look for the rest would answer
// another question.
bool refused_condition(const Step& step, const script::Topic& topic) {
  auto asks_by = [&](SlotId slot) {
    return std::any_of(
        topic.queries.begin(), topic.queries.end(), [&](const auto& query) {
          return std::any_of(query.by.begin(), query.by.end(),
                             [&](const auto& by) { return by.slot == slot; });
        });
  };
  return any_report(step, [&](const SlotReport& report) {
    return report.outcome == SlotOutcome::refused && asks_by(report.slot);
  });
}

} // namespace

void TopicEngine::settle(Step& step) {
  if (confirms_first(step) || heeds_refusals(step))
    return;
  const auto& topic = context_.topic(step.topic);
  const auto& frame = context_.frame(step.topic);
  if (topic.kind == script::TopicKind::enquiry) {
    if (frame.status != TopicStatus::suspended) // for a topic that it needs
      settle_enquiry(step);
    return;
  }
  if (frame.status != TopicStatus::active || !frame.done ||
      doubtful(step.topic) != script::no_id)
    return;
  if (topic.filled == script::no_code) {
    complete(step);
    return;
  }
  StepList steps;
  run_body(topic.filled, step.topic, script::no_id, step.turn, steps);
  steps.push_back(light_step(StepKind::finish, step));
  context_.lane.now(std::move(steps));
}

void TopicEngine::settle_enquiry(Step& step) {
  auto ask = light_step(StepKind::ask, step);
  ask.slot = doubtful(step.topic);
  const bool looked_for = step.result && step.result->query_slot_filled;
  if (ask.slot == script::no_id && !looked_for)
    ask.slot = missing(step.topic);
  if (ask.slot != script::no_id) {
    set_status(step.topic, TopicStatus::active);
    if (!may_ask(step.topic) && doubtful(step.topic) == script::no_id)
      return;                                   // it is left to the user
    if (!asked_ || asked_->topic != step.topic) // by an <ambiguous>
      context_.lane.at_once(std::move(ask));
  } else if ((!looked_for && refused_any(step)) ||
             refused_condition(step, context_.topic(step.topic))) {
    rest(step.topic); // nothing is left to look for
  } else if (!context_.topic(step.topic).queries.empty()) {
    look_up(step);
  } else {
    answer_enquiry(step);
  }
}

void TopicEngine::answer_enquiry(const Step& step) {
  StepList steps;
  run_body(context_.topic(step.topic).filled, step.topic, script::no_id,
           step.turn, steps);
  auto answer = light_step(StepKind::answer, step);
  answer.mark = output_.told();
  steps.push_back(std::move(answer));
  context_.lane.now(std::move(steps));
}

// The frame is completed unless its <filled> asked, cleared or left, or heard
// a no.
void TopicEngine::finish(Step& step) {
  const auto& frame = context_.frame(step.topic);
  if (!heeds_refusals(step) && frame.done &&
      frame.status == TopicStatus::active &&
      !runner_.redirected(context_.topic(step.topic).filled))
    complete(step);
}

// Once for each time that it was begun.
void TopicEngine::complete(Step& step) {
  const auto status = context_.frame(step.topic).status;
  if (status != TopicStatus::active && status != TopicStatus::suspended &&
      status != TopicStatus::resting)
    return;
  auto steps = end_confirms_of(step.topic);
  set_status(step.topic, TopicStatus::completed);
  completed_at_ = context_.now;
  context_.order.completed(step.topic);
  if (asked_ && asked_->topic == step.topic)
    asked_.reset();
  run_body(context_.topic(step.topic).completed, step.topic, script::no_id,
           step.turn, steps);
  if (auto next = needed_by(step.topic); next != script::no_id)
    steps.push_back(topic_step(StepKind::activate, next));
  context_.lane.now(std::move(steps));
}

// The suspended topic that waited for this one to be completed.
TopicId TopicEngine::needed_by(TopicId topic) const {
  for (auto other : context_.order.suspended())
    if (context_.order.needs(other, topic))
      return other;
  return script::no_id;
}

} // namespace parlour::dialogue
