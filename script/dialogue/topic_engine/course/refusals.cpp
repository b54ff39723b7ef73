#include "script/dialogue/topic_engine/course/refusals.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "script/dialogue/agenda/step_list.hpp"

namespace parlour::dialogue {

namespace {

// In `told` of a script that failed. As no count of outputs is that high, the
// topic is cancelled without further words.
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
// <suspended>, <cancelled>, <invalid> and the like do not: a no there says
// nothing about whether the topic is wanted.
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
void Refusals::body_failed(TopicId topic, CodeId body) {
  note_refusal(topic, body, by_failure);
}

void Refusals::note_no(TopicId topic, CodeId body) {
  note_refusal(topic, body, output_.told());
}

// The slot's value at the time of the no is kept, so that a <no> that sets
// another one is recognised later; so is how much scripts have done until then.
void Refusals::note_refusal(TopicId id, CodeId body, std::uint64_t told) {
  if (id == script::no_id)
    return;
  const auto& topic = context_.topic(id);
  const bool on_the_way =
      leads_to_completion(topic, body) && !has_ended(frames_[id].status);
  if (!on_the_way &&
      !(body == topic.completed && confirmations_.is_completing(id)))
    return;
  Refusal refusal;
  refusal.topic = id;
  refusal.body = body;
  refusal.told = told;
  refusal.deeds = running_.deeds();
  refusal.slot = slot_filled_by(topic, body);
  if (refusal.slot != script::no_id)
    refusal.value = frames_[id].slots[refusal.slot].value;
  refusals_.push_back(std::move(refusal));
}

// What its scripts were refused and have not dealt with themselves.
std::vector<Refusal> Refusals::take_refusals(TopicId topic) {
  std::vector<Refusal> open;
  std::erase_if(refusals_, [&](const Refusal& refusal) {
    if (refusal.topic == topic && !is_dealt_with(refusal))
      open.push_back(refusal);
    return refusal.topic == topic;
  });
  return open;
}

// By a clear, ask or transit, or by another value of the slot.
bool Refusals::is_dealt_with(const Refusal& refusal) const {
  if (running_.redirected(refusal.body))
    return true;
  if (refusal.slot == script::no_id)
    return false;
  const auto& slot = frames_[refusal.topic].slots[refusal.slot];
  return slot.status == SlotStatus::filled && slot.value != refusal.value;
}

// A no to going on with the topic, which nothing was done about.
bool Refusals::gives_up(const Refusal& refusal) const {
  return refusal.body == context_.topic(refusal.topic).resumed &&
         refusal.told != by_failure && refusal.deeds == running_.deeds();
}

// A refused value is taken back. Where the topic would be completed
// nevertheless, it ends: a no never leads there.
// First the values: a no in a slot's <filled> empties that slot. Of a value
// that was doubted before (no body), only if the topic would be completed with
// it. Then the topic: if it is still complete, nothing but the no stands in the
// way, so it ends. It says so, unless <no> has spoken, or the session is about
// to end anyway.
bool Refusals::heeds_refusals(TopicId topic, TurnId turn) {
  const auto refusals = take_refusals(topic);
  for (const auto& refusal : refusals)
    if (refusal.slot != script::no_id &&
        (refusal.body != script::no_code || frames_[topic].done))
      frames_.change(topic,
                     {.kind = FrameChange::Kind::clear, .slot = refusal.slot});
  const auto& frame = frames_[topic];
  const bool ends =
      frame.done || std::ranges::any_of(refusals, [&](const Refusal& refusal) {
        return gives_up(refusal);
      });
  if (refusals.empty() || !ends || has_ended(frame.status))
    return false;
  const bool has_spoken = output_.told() != refusals.back().told;
  context_.lane.at_once(steps::CancelTopic{
      topic, turn, has_spoken || context_.ending.is_wished()});
  return true;
}

// The value that was there before comes back; but a topic that would be
// completed with it asks: the user has just wanted another one.
void Refusals::doubt_earlier_value(TopicId topic, SlotId slot) {
  const auto& state = frames_[topic].slots[slot];
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
