#include "script/dialogue/context/topic_frames.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace parlour::dialogue {

TopicFrames::TopicFrames(DialogueContext& context,
                         script::Interpreter& interpreter)
    : context_(context), frames_(*context.program, interpreter),
      order_(*context.program) {}

SlotId TopicFrames::missing(TopicId topic) const {
  return missing_slot(context_.topic(topic), (*this)[topic]);
}

// The first slot that waits for a yes or a choice.
SlotId TopicFrames::doubtful(TopicId topic) const {
  const auto& slots = (*this)[topic].slots;
  for (SlotId slot = 0; slot < slots.size(); ++slot)
    if (slots[slot].status == SlotStatus::unconfirmed ||
        slots[slot].status == SlotStatus::ambiguous)
      return slot;
  return script::no_id;
}

// One that leaves the lead to the user never asks (engine rule 5).
bool TopicFrames::may_ask(TopicId topic) const {
  return context_.topic(topic).initiative != script::Initiative::user;
}

// A filling event without changes computes the slots' `if` anew; topics without
// any are left as they are.
void TopicFrames::refresh(TopicId topic) {
  const auto& slots = context_.topic(topic).slots;
  if (std::ranges::any_of(slots, [](const script::Slot& slot) {
        return slot.condition != script::no_code;
      }))
    frames_.apply(topic, {}, context_.now);
}

void TopicFrames::change(TopicId topic, const FrameChange& change) {
  context_.conceal(topic, {&change, 1});
  for (const auto& report : frames_.change(topic, change, context_.now))
    inspect_report(topic, report);
}

// A topic that has the status already is not changed, and nothing is shown.
void TopicFrames::set_status(TopicId topic, TopicStatus status) {
  if ((*this)[topic].status == status)
    return;
  frames_.set_status(topic, status, context_.now);
  if (context_.port.inspected())
    context_.inspect(InspectionKind::topic, context_.topic(topic).name,
                     std::string(name_of(status)));
}

void TopicFrames::count_question(TopicId topic, SlotId slot) {
  frames_.count_question(topic, slot, context_.now);
}

FrameResult TopicFrames::apply(TopicId topic,
                               std::span<const FrameChange> changes) {
  return frames_.apply(topic, changes, context_.now);
}

FrameRequest TopicFrames::request(TopicId topic,
                                  std::vector<FrameChange> changes) {
  return frames_.request(topic, std::move(changes), context_.now);
}

void TopicFrames::store(FramePointer frame) {
  frames_.store(std::move(frame));
}

void TopicFrames::inspect_report(TopicId topic, const SlotReport& report) {
  if (!context_.port.inspected())
    return;
  const auto& slot = context_.topic(topic).slots[report.slot];
  auto value = slot.is_private
                   ? std::string("***")
                   : to_string((*this)[topic].slots[report.slot].value);
  context_.inspect(InspectionKind::slot,
                   context_.topic(topic).name + "." + slot.name,
                   value + " (" + std::string(name_of(report.outcome)) + ")");
}

void TopicFrames::complete(TopicId topic) {
  set_status(topic, TopicStatus::completed);
  order_.completed(topic);
}

void TopicFrames::cancel(TopicId topic) {
  change(topic, {.kind = FrameChange::Kind::reset});
  set_status(topic, TopicStatus::cancelled);
  order_.completed(topic);
}

void TopicFrames::answered(TopicId topic) {
  set_status(topic, TopicStatus::resting);
  order_.answered(topic, context_.now);
}

// Topics that were never touched need no reset, which would show as a change.
// The order forgets what was unregistered.
void TopicFrames::restart() {
  for (TopicId topic = 0; topic < context_.program->topics.size(); ++topic)
    if ((*this)[topic].status != TopicStatus::untouched)
      change(topic, {.kind = FrameChange::Kind::reset});
  order_ = TopicOrder(*context_.program);
}

std::optional<TopicId> TopicFrames::resting() const {
  return order_.resting(context_.now,
                        context_.program->settings.sessions.context_for);
}

void TopicFrames::conceal() {
  for (TopicId topic = 0; topic < context_.program->topics.size(); ++topic)
    if (const auto* frame = frames_.find(topic))
      for (SlotId slot = 0; slot < frame->slots.size(); ++slot)
        context_.conceal(topic, slot, frame->slots[slot].value);
}

} // namespace parlour::dialogue
