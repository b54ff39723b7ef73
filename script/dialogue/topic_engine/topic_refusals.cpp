// The part of the topic engine for a no on the way to a topic's completion,
// which never leads there (language rule 12.21).
#include <algorithm>
#include <limits>
#include <utility>

#include "script/dialogue/agenda/steps.hpp"
#include "script/dialogue/topic_engine/topic_engine.hpp"

namespace parlour::dialogue {

namespace {

// Whose <filled> the body is.
SlotId slot_filled_by(const script::Topic& topic, CodeId body) {
  const auto found =
      std::ranges::find(topic.slots, body, &script::Slot::filled);
  return found == topic.slots.end()
             ? script::no_id
             : static_cast<SlotId>(found - topic.slots.begin());
}

// Whether the topic may be completed when it has run.
bool leads_to_completion(const script::Topic& topic, CodeId body) {
  return body == topic.filled || body == topic.started ||
         body == topic.resumed || topic.has_rule(body) ||
         slot_filled_by(topic, body) != script::no_id;
}

bool has_ended(TopicStatus status) {
  return status == TopicStatus::completed || status == TopicStatus::cancelled;
}

} // namespace

// What failed needs no further words.
void TopicEngine::body_failed(TopicId topic, CodeId body) {
  note_refusal(topic, body, std::numeric_limits<std::uint64_t>::max());
}

void TopicEngine::note_refusal(TopicId id, CodeId body, std::uint64_t told) {
  if (id == script::no_id || !leads_to_completion(context_.topic(id), body) ||
      has_ended(context_.frame(id).status))
    return;
  Refusal refusal;
  refusal.topic = id;
  refusal.body = body;
  refusal.told = told;
  refusal.slot = slot_filled_by(context_.topic(id), body);
  if (refusal.slot != script::no_id)
    refusal.value = context_.frame(id).slots[refusal.slot].value;
  refusals_.push_back(std::move(refusal));
}

// What its scripts were refused and have not dealt with themselves.
std::vector<Refusal> TopicEngine::take_refusals(TopicId topic) {
  std::vector<Refusal> open;
  std::erase_if(refusals_, [&](const Refusal& refusal) {
    if (refusal.topic == topic && !is_dealt_with(refusal))
      open.push_back(refusal);
    return refusal.topic == topic;
  });
  return open;
}

// By a clear, ask or transit, or by another value of the slot.
bool TopicEngine::is_dealt_with(const Refusal& refusal) const {
  if (runner_.redirected(refusal.body))
    return true;
  if (refusal.slot == script::no_id)
    return false;
  const auto& slot = context_.frame(refusal.topic).slots[refusal.slot];
  return slot.status == SlotStatus::filled && slot.value != refusal.value;
}

// A refused value is taken back. Where the topic would be completed
// nevertheless, it ends: a no never leads there.
bool TopicEngine::heeds_refusals(const Step& step) {
  const auto refusals = take_refusals(step.topic);
  for (const auto& refusal : refusals)
    if (refusal.slot != script::no_id &&
        (refusal.body != script::no_code || context_.frame(step.topic).done))
      change(step.topic,
             {.kind = FrameChange::Kind::clear, .slot = refusal.slot});
  const auto& frame = context_.frame(step.topic);
  if (refusals.empty() || !frame.done || has_ended(frame.status))
    return false;
  auto ending = light_step(StepKind::cancel_topic, step);
  const bool has_spoken = output_.told() != refusals.back().told;
  ending.mark = has_spoken || context_.ending;
  context_.lane.at_once(std::move(ending));
  return true;
}

} // namespace parlour::dialogue
