#include "script/dialogue/context/privacy.hpp"

#include <unordered_set>
#include <utility>

#include "script/spoken/spoken.hpp"

namespace parlour::dialogue {

namespace {

// A number, also one that is written in a text; nothing for all else.
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
constexpr std::size_t min_heard = 4;

// Calls `with` for each text and number in the value.
template <class With>
void for_each_part(const Value& value, const With& with) {
  if (const auto* list = value.if_list())
    for (const auto& element : *list)
      for_each_part(element, with);
  if (const auto* map = value.if_map())
    for (const auto& entry : map->entries())
      for_each_part(entry.second, with);
  if (const auto* result = value.if_result())
    for (const auto& cell : result->cells)
      for_each_part(cell, with);
  if (value.if_string() || value.if_integer() || value.if_number())
    with(value);
}

// It as it is printed and as it is spoken: of 4711 also "four seven one one",
// as a phrase or a voice may say it in that way.
void collect(const Value& part, const std::string& kind, Timestamp now,
             std::vector<std::string>& texts) {
  const script::ToSay what{to_string(part), decimal(part), now};
  texts.push_back(what.text);
  for (const auto& way : {kind, std::string("number"), std::string("digits")})
    texts.push_back(script::spoken(what, way));
}

} // namespace

Privacy::Privacy(const script::Program& program,
                 const script::Interpreter& interpreter, Port& port)
    : program_(program), interpreter_(interpreter), port_(port),
      is_needed_(script::has_private(program)) {
  const auto& variables = program.variables;
  for (std::size_t i = 0; i < variables.size(); ++i)
    if (variables[i].is_private)
      variables_.push_back(i);
  known_.resize(variables_.size());
}

// The values are compared, as scripts change lists and maps in place. They are
// copied for that, so where nothing has changed nothing is compared. After a
// restore they are compared once more, which changes nothing.
void Privacy::note_variables(Timestamp now) {
  if (variables_.empty() || writes_ == interpreter_.writes())
    return;
  writes_ = interpreter_.writes();
  for (std::size_t i = 0; i < variables_.size(); ++i) {
    auto value = interpreter_.variable(variables_[i]);
    if (value == known_[i])
      continue;
    conceal(value, "", now, known_[i]);
    known_[i] = std::move(value);
  }
}

void Privacy::note(TopicId topic, SlotId slot, const Value& value,
                   Timestamp now) {
  const auto& slots = program_.topics[topic].slots;
  if (slot < slots.size() && slots[slot].is_private)
    conceal(value, slots[slot].cardinality.type, now);
}

// What is offered is hidden before it is known whether the slot takes it: a PIN
// that was refused is private, too.
void Privacy::note(TopicId topic, std::span<const FrameChange> changes,
                   Timestamp now) {
  if (!is_needed_)
    return;
  for (const auto& change : changes) {
    note(topic, change.slot, change.value, now);
    note(topic, change.slot, change.candidates, now);
    if (change.text.size() >= min_heard)
      note(topic, change.slot, change.text, now);
  }
}

void Privacy::hear(bool is_asked_in_private) {
  if (is_needed_ && is_asked_in_private)
    port_.conceal_turn();
}

void Privacy::resume(Timestamp now) {
  for (const auto& value : known_)
    conceal(value, "", now);
}

void Privacy::settle(std::uint64_t received) {
  if (is_needed_)
    port_.settled(received);
}

// Of a list that grows, only what is new is told: the port forgets the oldest
// of what it was told.
void Privacy::conceal(const Value& value, const std::string& kind,
                      Timestamp now, const Value& told) {
  std::unordered_set<std::string> known;
  for_each_part(told,
                [&](const Value& part) { known.insert(to_string(part)); });
  std::vector<std::string> texts;
  for_each_part(value, [&](const Value& part) {
    if (!known.contains(to_string(part)))
      collect(part, kind, now, texts);
  });
  if (!texts.empty())
    port_.conceal(texts);
}

} // namespace parlour::dialogue
