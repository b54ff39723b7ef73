#include "adapters/mqtt/discovery/payload.hpp"

namespace parlour::adapters::mqtt {

std::string text_of(const Value& value) {
  if (const auto* truth = value.if_boolean())
    return *truth ? "True" : "False";
  if (value.is_unknown())
    return "None";
  return value.if_list() || value.if_map() ? json_text(value) : value.text();
}

const Value* Payload::json() const {
  if (!json_)
    json_ = read_json(text_);
  return *json_ ? &**json_ : nullptr;
}

} // namespace parlour::adapters::mqtt
