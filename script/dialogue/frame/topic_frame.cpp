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

SlotState new_slot(const script::Slot& slot, TopicFrame& frame,
                   const FrameEvaluator& evaluate) {
  SlotState state;
  if (slot.initial == script::no_code)
    return state;
  auto value = evaluate(slot.initial, frame, nullptr);
  if (!value)
    frame.errors.push_back(value.error());
  if (!value || value->is_unknown())
    return state;
  state.value = *value;
  state.status = SlotStatus::filled;
  state.by_default = true;
  return state;
}

// Slots are made in file order, so an initial value may read slots before it.
// Conditions come last, as they may read any slot.
TopicFrame new_frame(const script::Program& program, TopicId topic,
                     const FrameEvaluator& evaluate) {
  const auto& slots = program.topics[topic].slots;
  TopicFrame frame;
  frame.topic = topic;
  frame.slots.resize(slots.size());
  for (std::size_t i = 0; i < slots.size(); ++i)
    if (slots[i].initial != script::no_code)
      frame.slots[i] = new_slot(slots[i], frame, evaluate);
  judge_conditions(program.topics[topic], frame, evaluate, nullptr);
  return frame;
}

void judge_conditions(const script::Topic& topic, TopicFrame& frame,
                      const FrameEvaluator& evaluate,
                      std::vector<Error>* errors) {
  for (SlotId slot = 0; slot < topic.slots.size(); ++slot) {
    const auto condition = topic.slots[slot].condition;
    if (condition == script::no_code)
      continue;
    const auto holds = evaluate(condition, frame, nullptr);
    frame.slots[slot].applies = holds && *holds;
    if (!holds && errors)
      errors->push_back(holds.error());
  }
}

bool is_open(const script::Slot& slot, const SlotState& state) {
  return slot.more != script::no_code && !state.closed &&
         state.status == SlotStatus::filled && !state.by_default;
}

SlotId missing_slot(const script::Topic& topic, const TopicFrame& frame) {
  for (SlotId slot = 0; slot < topic.slots.size(); ++slot)
    if (topic.slots[slot].functional && frame.slots[slot].applies &&
        (frame.slots[slot].status != SlotStatus::filled ||
         is_open(topic.slots[slot], frame.slots[slot])))
      return slot;
  return script::no_id;
}

} // namespace parlour::dialogue
