#include "script/dialogue/questions/topic_words.hpp"

#include <utility>

namespace parlour::dialogue {

void TopicWords::say(const char* act, TopicId topic, SlotId slot, Value data,
                     TurnId turn) {
  Say what;
  what.act = act;
  what.topic = topic;
  what.slot = slot;
  what.data = with_marks(topic, std::move(data));
  what.turn = turn;
  output_.say(std::move(what));
}

// Values to be echoed in what is said of their topic (grounding: implicit).
Value TopicWords::with_marks(TopicId topic, Value data) const {
  if (topic == script::no_id)
    return data;
  const auto& slots = context_.topic(topic).slots;
  Map marked;
  for (SlotId slot = 0; slot < slots.size(); ++slot)
    if (const auto& state = frames_[topic].slots[slot]; state.implicit)
      marked.set(slots[slot].name, state.value);
  if (marked.empty())
    return data;
  auto map = data.if_map() ? *data.if_map() : Map();
  map.set("implicit", std::move(marked));
  return map;
}

// How its values are said.
Value TopicWords::with_type(Map data, TopicId topic, SlotId slot) const {
  const auto& type = context_.topic(topic).slots[slot].cardinality.type;
  if (!type.empty())
    data.set("type", type);
  return data;
}

Value TopicWords::label_of(TopicId topic, SlotId slot) const {
  if (topic == script::no_id)
    return {};
  const auto& definition = context_.topic(topic);
  const auto code =
      slot == script::no_id ? definition.label : definition.slots[slot].label;
  return code == script::no_code ? Value() : Value(texts_.text_of(code, topic));
}

Map TopicWords::with_label(Map data, TopicId topic, SlotId slot) const {
  if (auto label = label_of(topic, slot); !label.is_unknown())
    data.set("label", std::move(label));
  return data;
}

namespace {

// Of what a topic of its own has filled, the values are said.
Value to_say(const Value& value) {
  const auto* map = value.if_map();
  if (!map)
    return value;
  List values;
  for (const auto& [name, one] : map->entries())
    values.push_back(one);
  return values;
}

} // namespace

Value TopicWords::told(TopicId topic) const {
  const auto& slots = context_.topic(topic).slots;
  List told;
  for (SlotId slot = 0; slot < slots.size(); ++slot) {
    const auto& state = frames_[topic].slots[slot];
    if (state.status == SlotStatus::filled && state.applies &&
        (slots[slot].functional || !state.by_default))
      told.emplace_back(
          with_type(with_label(Map{{"slot", slots[slot].name},
                                   {"value", to_say(state.value)}},
                               topic, slot),
                    topic, slot));
  }
  return told;
}

void TopicWords::repeat(TurnId turn) {
  if (output_.said_anything())
    output_.repeat_last(turn);
  else
    say("repeat_nothing", script::no_id, script::no_id, {}, turn);
}

} // namespace parlour::dialogue
