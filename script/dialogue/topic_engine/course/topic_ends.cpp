#include "script/dialogue/topic_engine/course/topic_ends.hpp"

#include <algorithm>
#include <utility>

#include "script/dialogue/questions/bodies.hpp"

namespace parlour::dialogue {

namespace {

bool is_open(TopicStatus status) {
  return status == TopicStatus::active || status == TopicStatus::suspended;
}

} // namespace

// A topic that cannot be cancelled is left out rather than an error: "cancel
// the taxi" when no taxi was ordered is answered like a cancel of nothing.
std::vector<TopicId> TopicEnds::meant_by(const steps::Cancel& step) const {
  auto topics = std::vector{step.topic};
  if (step.all)
    topics = whereabouts_.unfinished();
  else if (step.topic == script::no_id)
    topics = {to_cancel()};
  std::erase_if(topics, [&](TopicId topic) {
    return topic == script::no_id || !can_be_cancelled(topic);
  });
  return topics;
}

StepList TopicEnds::cancel(const std::vector<TopicId>& topics, TurnId turn) {
  StepList steps;
  const bool several = topics.size() > 1; // one word is enough
  for (auto topic : topics)
    steps.add(steps::CancelTopic{topic, turn, several});
  if (several)
    words_.say("cancelled_all", script::no_id, script::no_id, {}, turn);
  else if (topics.empty())
    words_.say("cancelled", script::no_id, script::no_id, {}, turn);
  return steps;
}

// The frame is emptied before <cancelled> runs, so that body reads initial
// values. A topic that is a part (engine rule 5.15) takes with it the suspended
// one that waits for it: that one could only ask for the part again.
void TopicEnds::take(const steps::CancelTopic& step) {
  auto steps = confirmations_.end_confirms_of(step.topic);
  if (question_ && question_->topic == step.topic)
    asking_.withdraw();
  frames_.cancel(step.topic);
  if (!step.silent)
    words_.say("cancelled", step.topic, script::no_id, {}, step.turn);
  run_body(context_.topic(step.topic).cancelled, step.topic, script::no_id,
           step.turn, steps);
  for (auto whole : frames_.order().suspended()) // it cannot go on without
    if (context_.topic(whole).has_part(step.topic))
      steps.add(steps::CancelTopic{whole, step.turn, true});
  context_.lane.now(std::move(steps));
}

void TopicEnds::take(const steps::Reset& step) {
  auto steps = confirmations_.end_confirms_of(step.topic);
  frames_.change(step.topic, {.kind = FrameChange::Kind::reset});
  context_.lane.now(std::move(steps));
}

// A <confirm> that is no topic's is all that is cancelled then.
TopicId TopicEnds::to_cancel() const {
  if (question_ && (question_->topic != script::no_id || question_->wait != 0))
    return question_->topic;
  if (auto current = frames_.order().current())
    return *current;
  if (const auto topic = confirmations_.completing(); topic != script::no_id)
    return topic;
  const auto& suspended = frames_.order().suspended();
  return suspended.empty() ? script::no_id : suspended.front();
}

bool TopicEnds::can_be_cancelled(TopicId topic) const {
  return is_open(frames_[topic].status) || confirmations_.is_completing(topic);
}

} // namespace parlour::dialogue
