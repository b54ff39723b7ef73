#include "script/dialogue/engine/privacy.hpp"

#include <utility>

#include "script/dialogue/engine/core.hpp"
#include "script/spoken/spoken.hpp"

namespace parlour::dialogue {

namespace {

std::optional<Decimal> decimal(const Value& value) {
  if (const auto* integer = value.if_integer())
    return decimal_of(*integer);
  if (const auto* number = value.if_number())
    return decimal_of(*number);
  const auto* text = value.if_string();
  const auto written = text ? parse_number(*text) : Value();
  return written.is_unknown() ? std::nullopt : decimal(written);
}

// A text as it was heard that is too short tells nothing, and would hide much.
constexpr std::size_t least_heard = 4;

} // namespace

Privacy::Privacy(Core& core)
    : core_(core), is_needed_(script::has_private(*core.program)) {
  const auto& variables = core.program->variables;
  for (std::size_t i = 0; i < variables.size(); ++i)
    if (variables[i].is_private)
      variables_.push_back(i);
  known_.resize(variables_.size());
}

void Privacy::note_variables() {
  for (std::size_t i = 0; i < variables_.size(); ++i) {
    auto value = core_.interpreter.variable(variables_[i]);
    if (value == known_[i])
      continue;
    known_[i] = std::move(value);
    conceal(known_[i], "");
  }
}

void Privacy::note(TopicId topic, SlotId slot, const Value& value) {
  const auto& slots = core_.topic(topic).slots;
  if (slot < slots.size() && slots[slot].is_private)
    conceal(value, slots[slot].cardinality.type);
}

void Privacy::note(TopicId topic, std::span<const FrameChange> changes) {
  if (!is_needed_)
    return;
  for (const auto& change : changes) {
    note(topic, change.slot, change.value);
    note(topic, change.slot, change.candidates);
    if (change.text.size() >= least_heard)
      note(topic, change.slot, change.text);
  }
}

void Privacy::hear() {
  if (is_needed_ && core_.topics.asks_in_private())
    core_.port.conceal_turn();
}

void Privacy::settle(std::uint64_t received) {
  if (is_needed_)
    core_.port.settled(received);
}

void Privacy::conceal(const Value& value, const std::string& kind) {
  std::vector<std::string> texts;
  collect(value, kind, texts);
  if (!texts.empty())
    core_.port.conceal(texts);
}

void Privacy::collect(const Value& value, const std::string& kind,
                      std::vector<std::string>& texts) const {
  if (const auto* list = value.if_list())
    for (const auto& element : *list)
      collect(element, kind, texts);
  if (const auto* map = value.if_map())
    for (const auto& entry : map->entries())
      collect(entry.second, kind, texts);
  if (const auto* result = value.if_result())
    for (const auto& cell : result->cells)
      collect(cell, kind, texts);
  if (!value.if_string() && !value.if_integer() && !value.if_number())
    return;
  const script::ToSay what{to_string(value), decimal(value), core_.now};
  texts.push_back(what.text);
  for (const auto& way : {kind, std::string("number"), std::string("digits")})
    texts.push_back(script::spoken(what, way));
}

} // namespace parlour::dialogue
