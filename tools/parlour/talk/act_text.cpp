#include "tools/parlour/talk/act_text.hpp"

#include "runtime/message/understanding.hpp"

namespace parlour::tools {

namespace {

// "Time = 15:00, Place = hall" behind a colon. A slot is a value, or a map with
// `value` and, if that is unknown, `candidates`.
std::string slots_text(const Value& slots) {
  std::string text;
  const auto* map = slots.if_map();
  if (!map)
    return text;
  for (const auto& [name, given] : map->entries()) {
    const auto* parts = given.if_map();
    const auto value = parts ? given["value"] : given;
    text += (text.empty() ? ": " : ", ") + name + " = ";
    text += parts && value.is_unknown() ? to_string(given["candidates"])
                                        : to_string(value);
  }
  return text;
}

// The act and its topic.
std::string head_text(const Value& act) {
  auto text = act[act_key::act].text();
  if (const auto topic = act[act_key::topic]; !topic.is_unknown())
    text += " " + topic.text();
  return text;
}

} // namespace

std::string act_text(const Value& act) {
  auto text = head_text(act);
  if (const auto confidence = act[act_key::confidence];
      !confidence.is_unknown())
    text += " (" + to_string(confidence) + ")";
  return text + slots_text(act[act_key::slots]);
}

std::string act_text_without_confidence(const Value& act) {
  return head_text(act) + slots_text(act[act_key::slots]);
}

} // namespace parlour::tools
