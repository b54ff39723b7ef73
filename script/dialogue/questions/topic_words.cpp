#include "script/dialogue/questions/topic_words.hpp"

#include <utility>

#include "script/program/constant_text.hpp"

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

std::string TopicWords::text_of(CodeId code, TopicId topic) {
  if (code == script::no_code)
    return {};
  if (auto constant = script::constant_text(*context_.program, code))
    return std::string(*constant);
  auto text = runner_.evaluate(code, {}, topic);
  if (text)
    return text->text();
  context_.inspect(InspectionKind::error, context_.topic(topic).name,
                   to_string(text.error()));
  return {};
}

Value TopicWords::choices_of(TopicId topic, SlotId slot) {
  const auto& taken = context_.topic(topic).slots[slot].cardinality;
  List choices;
  for (auto code : taken.values)
    choices.emplace_back(text_of(code, topic));
  Map said{{"choices", std::move(choices)}};
  if (taken.minimum != script::no_code)
    said.set("from", text_of(taken.minimum, topic));
  if (taken.maximum != script::no_code)
    said.set("to", text_of(taken.maximum, topic));
  return said;
}

void TopicWords::repeat(TurnId turn) {
  if (output_.said_anything())
    output_.repeat_last(turn);
  else
    say("repeat_nothing", script::no_id, script::no_id, {}, turn);
}

} // namespace parlour::dialogue
