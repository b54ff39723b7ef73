#include "script/program/host.hpp"

#include <limits>

#include "script/values/convert.hpp"
#include "script/values/objects.hpp"

namespace parlour::script {

namespace {

// What can be too large was weighed before the effect was performed.
Value copied(const Box& box) {
  return to_value(box, std::numeric_limits<std::size_t>::max());
}

} // namespace

bool Effect::has(std::size_t index) const {
  return index < operands_.size() && !operands_[index].resolved().is_unknown();
}

Value Effect::operand(std::size_t index) const {
  return index < operands_.size() ? copied(operands_[index]) : Value();
}

std::string Effect::text(std::size_t index) const {
  if (index < operands_.size())
    if (const auto& box = operands_[index].resolved(); box.is_string())
      return std::string(box.text());
  return operand(index).text();
}

std::vector<Value> Effect::captured() const {
  std::vector<Value> values;
  values.reserve(captured_.size());
  for (const auto& box : captured_)
    values.push_back(copied(box));
  return values;
}

} // namespace parlour::script
