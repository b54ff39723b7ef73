#include "script/dialogue/frame/topic_frame.hpp"

#include <array>

namespace parlour::dialogue {

std::string_view name_of(TopicStatus status) {
  constexpr std::array names = {
      std::string_view("untouched"), std::string_view("active"),
      std::string_view("suspended"), std::string_view("resting"),
      std::string_view("completed"), std::string_view("cancelled"),
  };
  return names[static_cast<std::size_t>(status)];
}

std::string_view name_of(SlotOutcome outcome) {
  constexpr std::array names = {
      std::string_view("accepted"),    std::string_view("corrected"),
      std::string_view("unconfirmed"), std::string_view("ambiguous"),
      std::string_view("refused"),     std::string_view("rejected"),
      std::string_view("cleared"),     std::string_view("unchanged"),
  };
  return names[static_cast<std::size_t>(outcome)];
}

SlotState new_slot(const script::Slot& slot, const TopicFrame& frame,
                   const FrameEvaluator& evaluate) {
  SlotState state;
  if (slot.initial == script::no_code)
    return state;
  auto value = evaluate(slot.initial, frame, nullptr);
  if (!value || value->is_unknown())
    return state;
  state.value = *value;
  state.status = SlotStatus::filled;
  state.by_default = true;
  return state;
}

TopicFrame new_frame(const script::Program& program, TopicId topic,
                     const FrameEvaluator& evaluate) {
  const auto& slots = program.topics[topic].slots;
  TopicFrame frame;
  frame.topic = topic;
  frame.slots.resize(slots.size());
  for (std::size_t i = 0; i < slots.size(); ++i)
    if (slots[i].initial != script::no_code)
      frame.slots[i] = new_slot(slots[i], frame, evaluate);
  return frame;
}

SlotId missing_slot(const script::Topic& topic, const TopicFrame& frame) {
  for (SlotId slot = 0; slot < topic.slots.size(); ++slot)
    if (topic.slots[slot].functional &&
        frame.slots[slot].status != SlotStatus::filled)
      return slot;
  return script::no_id;
}

} // namespace parlour::dialogue
