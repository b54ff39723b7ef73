#include "adapters/mqtt/discovery/entity.hpp"

#include <cmath>

namespace parlour::adapters::mqtt {

namespace {

// A cover that is not wholly closed counts as open.
std::optional<Value> position(const Entity& entity, const Value& number) {
  if (number.is_unknown())
    return {};
  const auto way = entity.open - entity.closed;
  const auto gone = number.number_or(0) - entity.closed;
  return std::abs(gone) < std::abs(way) / 200 ? "closed" : "open";
}

} // namespace

// "None" is what a template writes for a value that is not known.
std::optional<Value> meaning_of(const Entity& entity, const std::string& text) {
  if (text == "None")
    return Value();
  if (entity.meaning == Meaning::word) {
    const auto found = entity.words.find(text);
    return found == entity.words.end() ? std::nullopt
                                       : std::optional<Value>(found->second);
  }
  auto number = parse_number(text);
  if (entity.meaning == Meaning::position)
    return position(entity, number);
  return number.is_unknown() ? Value(text) : number;
}

} // namespace parlour::adapters::mqtt
