#include "script/dialogue/topic_engine/course/settling.hpp"

#include <algorithm>
#include <utility>

#include "script/dialogue/context/asked.hpp"
#include "script/dialogue/questions/bodies.hpp"

namespace parlour::dialogue {

namespace {

template <class Predicate>
bool any_report(const steps::Settle& step, Predicate holds) {
  return step.result && std::any_of(step.result->reports.begin(),
                                    step.result->reports.end(), holds);
}

bool refused_any(const steps::Settle& step) {
  return any_report(step, [](const SlotReport& report) {
    return report.outcome == SlotOutcome::refused ||
           report.outcome == SlotOutcome::rejected;
  });
}

// Something was asked for that there is not: to look for the rest would answer
// another question.
bool refused_condition(const steps::Settle& step, const script::Topic& topic) {
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

// The order is that of engine rule 5.4, step 7. Refusals come before the frame
// is looked at, as they may empty slots; then conditions are judged anew, since
// rules and bodies may have set variables. A task that is suspended is settled
// when it goes on.
void Settling::take(steps::Settle&& step) {
  if (confirmations_.confirms_first(step) ||
      refusals_.heeds_refusals(step.topic, step.turn))
    return;
  frames_.refresh(step.topic);
  const auto& topic = context_.topic(step.topic);
  const auto& frame = frames_[step.topic];
  if (topic.kind == script::TopicKind::enquiry) {
    if (frame.status != TopicStatus::suspended) // for a topic that it needs
      settle_enquiry(step);
    return;
  }
  if (frame.status != TopicStatus::active || !frame.done ||
      frames_.doubtful(step.topic) != script::no_id)
    return;
  if (asks_for_refused(step))
    return;
  if (topic.filled == script::no_code) {
    take(steps::Complete{step.topic, step.turn});
    return;
  }
  StepList steps;
  run_body(topic.filled, step.topic, script::no_id, step.turn, steps);
  steps.add(steps::Finish{step.topic, step.turn});
  context_.lane.now(std::move(steps));
}

// The frame is completed unless its <filled> asked, cleared or left, or heard
// a no.
void Settling::take(const steps::Finish& step) {
  const auto& frame = frames_[step.topic];
  if (!refusals_.heeds_refusals(step.topic, step.turn) && frame.done &&
      frame.status == TopicStatus::active &&
      !running_.redirected(context_.topic(step.topic).filled))
    take(steps::Complete{step.topic, step.turn});
}

// Once for each time that it was begun: the status changes here, and a second
// <complete/> finds the topic completed. The frame keeps its values, so that
// <completed> reads them.
void Settling::take(const steps::Complete& step) {
  const auto status = frames_[step.topic].status;
  if (status != TopicStatus::active && status != TopicStatus::suspended &&
      status != TopicStatus::resting)
    return;
  auto steps = confirmations_.end_confirms_of(step.topic);
  frames_.complete(step.topic);
  completed_at_ = context_.now;
  question_.reset_of(step.topic);
  run_body(context_.topic(step.topic).completed, step.topic, script::no_id,
           step.turn, steps);
  steps.add(steps::WindUp{step.topic, step.turn});
  context_.lane.now(std::move(steps));
}

// A no to all that <completed> had to do: nothing was completed, so the topic
// is cancelled after all. Otherwise the topic that needed this one goes on.
void Settling::take(const steps::WindUp& step) {
  const bool refused = !refusals_.take_refusals(step.topic).empty();
  const auto& topic = context_.topic(step.topic);
  if (refused && !running_.acted(topic.completed) &&
      frames_[step.topic].status == TopicStatus::completed) {
    context_.lane.at_once(
        steps::CancelTopic{step.topic, step.turn, context_.ending.is_wished()});
  } else if (auto next = topic_changes_.needed_by(step.topic);
             next != script::no_id) {
    context_.lane.now(
        topic_changes_.back_to_needing(next, step.topic, step.turn));
  }
}

// What was wanted and does not fit is asked for, not left out; unless its
// <invalid> has seen to that. "A table for four, on the terrace" with no
// terrace: the table is not booked inside unasked. A slot without a question of
// its own cannot be asked for: what was said about the refusal counts as its
// question, and the next words may answer it.
bool Settling::asks_for_refused(const steps::Settle& step) {
  const auto& slots = context_.topic(step.topic).slots;
  const auto needs_asking = [&](const SlotReport& report) {
    const auto invalid = slots[report.slot].invalid;
    return report.outcome == SlotOutcome::refused &&
           (invalid == script::no_code ||
            (!running_.redirected(invalid) &&
             frames_[step.topic].slots[report.slot].status !=
                 SlotStatus::filled));
  };
  if (step.told || !any_report(step, needs_asking))
    return false;
  const auto slot =
      std::ranges::find_if(step.result->reports, needs_asking)->slot;
  const steps::Ask ask{step.topic, slot, step.turn};
  if (slots[ask.slot].question == script::no_code)
    question_.set(asked_by_others(Asked::For::value, ask.topic, ask.slot,
                                  ask.turn)); // what was told of it asks
  else
    context_.lane.at_once(ask);
  return true;
}

// What is in doubt is asked for. What is missing is asked for only if this
// event filled nothing that a query uses: "any coffee shop?" is looked up with
// what there is (engine rule 5.1). The enquiry rests without a lookup if
// something was refused and nothing else is there to look for, or if a query
// needs what was refused: the rest would be another question (engine rule 6.4).
void Settling::settle_enquiry(const steps::Settle& step) {
  steps::Ask ask{step.topic, frames_.doubtful(step.topic), step.turn};
  const bool looked_for = step.result && step.result->query_slot_filled;
  if (ask.slot == script::no_id && !looked_for)
    ask.slot = frames_.missing(step.topic);
  if (ask.slot != script::no_id) {
    frames_.set_status(step.topic, TopicStatus::active);
    if (!frames_.may_ask(step.topic) &&
        frames_.doubtful(step.topic) == script::no_id)
      return;                                         // it is left to the user
    if (!question_ || question_->topic != step.topic) // by an <ambiguous>
      context_.lane.at_once(ask);
  } else if ((!looked_for && refused_any(step)) ||
             refused_condition(step, context_.topic(step.topic))) {
    topic_changes_.answered(step.topic); // nothing is left to look for
  } else if (!context_.topic(step.topic).queries.empty()) {
    enquiries_.take(steps::LookUp{step.topic, step.turn});
  } else {
    enquiries_.answer_enquiry(step.topic, step.turn);
  }
}

} // namespace parlour::dialogue
