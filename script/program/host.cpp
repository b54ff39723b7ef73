// Operands of effects as values of the runtime. They are converted on demand,
// because many effects need only some of their operands.

#include "script/program/host.hpp"

#include <limits>

#include "script/values/convert.hpp"
#include "script/values/objects.hpp"

namespace parlour::script {

namespace {

// The sizes were checked before the effect was performed.
Value copied(const Box& box) {
  WalkBudget any(std::numeric_limits<std::size_t>::max());
  return to_value(box, any);
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
