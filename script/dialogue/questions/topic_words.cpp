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

void TopicWords::repeat(TurnId turn) {
  if (output_.said_anything())
    output_.repeat_last(turn);
  else
    say("repeat_nothing", script::no_id, script::no_id, {}, turn);
}

} // namespace parlour::dialogue
