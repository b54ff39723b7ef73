// The part of the topic engine for a no on the way to a topic's completion,
// which never leads there (language rule 12.21).
#include <algorithm>
#include <limits>
#include <utility>

#include "script/dialogue/agenda/steps.hpp"
#include "script/dialogue/topic_engine/topic_engine.hpp"

namespace parlour::dialogue {

namespace {

constexpr auto by_failure = std::numeric_limits<std::uint64_t>::max();

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
  note_refusal(topic, body, by_failure);
}

void TopicEngine::note_refusal(TopicId id, CodeId body, std::uint64_t told) {
  if (id == script::no_id)
    return;
  const auto& topic = context_.topic(id);
  const bool on_the_way =
      leads_to_completion(topic, body) && !has_ended(context_.frame(id).status);
  if (!on_the_way && !(body == topic.completed && is_completing(id)))
    return;
  Refusal refusal;
  refusal.topic = id;
  refusal.body = body;
  refusal.told = told;
  refusal.deeds = runner_.deeds();
  refusal.slot = slot_filled_by(topic, body);
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

// A no to going on with the topic, which nothing was done about.
bool TopicEngine::gives_up(const Refusal& refusal) const {
  return refusal.body == context_.topic(refusal.topic).resumed &&
         refusal.told != by_failure && refusal.deeds == runner_.deeds();
}

// Who takes back the value that is asked about says no to it.
void TopicEngine::heed_denial(TopicId topic, SlotId slot) {
  const auto body = context_.topic(topic).slots[slot].filled;
  const auto found = std::ranges::find_if(confirms_, [&](const Asked& confirm) {
    return confirm.topic == topic && confirm.body == body && !confirm.anew;
  });
  if (found == confirms_.end())
    return;
  const auto asked = *found;
  forget_question(asked);
  answer_confirm(asked, false);
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
  const bool ends =
      frame.done || std::ranges::any_of(refusals, [&](const Refusal& refusal) {
        return gives_up(refusal);
      });
  if (refusals.empty() || !ends || has_ended(frame.status))
    return false;
  auto ending = light_step(StepKind::cancel_topic, step);
  const bool has_spoken = output_.told() != refusals.back().told;
  ending.mark = has_spoken || context_.ending;
  context_.lane.at_once(std::move(ending));
  return true;
}

} // namespace parlour::dialogue
