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

// What was told of the refusal asks for another value.
Asked asked_by_refusal(const Step& step) {
  Asked asked;
  asked.topic = step.topic;
  asked.slot = step.slot;
  asked.turn = step.turn;
  asked.pending = false;
  asked.heard = true;
  return asked;
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
  if (asks_for_refused(step))
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

// What was wanted and does not fit is asked for, not left out; unless its
// <invalid> has seen to that.
bool TopicEngine::asks_for_refused(const Step& step) {
  const auto& slots = context_.topic(step.topic).slots;
  const auto needs_asking = [&](const SlotReport& report) {
    const auto invalid = slots[report.slot].invalid;
    return report.outcome == SlotOutcome::refused &&
           (invalid == script::no_code ||
            (!runner_.redirected(invalid) &&
             context_.frame(step.topic).slots[report.slot].status !=
                 SlotStatus::filled));
  };
  if (step.mark != 0 || !any_report(step, needs_asking))
    return false;
  auto ask = light_step(StepKind::ask, step);
  ask.slot = std::ranges::find_if(step.result->reports, needs_asking)->slot;
  if (slots[ask.slot].question == script::no_code)
    asked_ = asked_by_refusal(ask);
  else
    context_.lane.at_once(std::move(ask));
  return true;
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
  steps.push_back(light_step(StepKind::wind_up, step));
  context_.lane.now(std::move(steps));
}

// A no to all that <completed> had to do: nothing was completed.
void TopicEngine::wind_up(Step& step) {
  const bool refused = !take_refusals(step.topic).empty();
  const auto& topic = context_.topic(step.topic);
  if (refused && !runner_.acted(topic.completed) &&
      context_.frame(step.topic).status == TopicStatus::completed) {
    auto ending = light_step(StepKind::cancel_topic, step);
    ending.mark = context_.ending;
    context_.lane.at_once(std::move(ending));
  } else if (auto next = needed_by(step.topic); next != script::no_id) {
    context_.lane.at_once(topic_step(StepKind::activate, next));
  }
}

bool TopicEngine::is_completing(TopicId topic) const {
  const auto body = context_.topic(topic).completed;
  return context_.frame(topic).status == TopicStatus::completed &&
         !runner_.acted(body) &&
         std::ranges::any_of(confirms_, [&](const Asked& confirm) {
           return confirm.topic == topic && confirm.body == body;
         });
}

TopicId TopicEngine::completing() const {
  const auto found = std::find_if(
      confirms_.rbegin(), confirms_.rend(), [&](const Asked& confirm) {
        return confirm.topic != script::no_id && is_completing(confirm.topic);
      });
  return found == confirms_.rend() ? script::no_id : found->topic;
}

// The suspended topic that waited for this one to be completed.
TopicId TopicEngine::needed_by(TopicId topic) const {
  for (auto other : context_.order.suspended())
    if (context_.order.needs(other, topic))
      return other;
  return script::no_id;
}

} // namespace parlour::dialogue
