#include "script/dialogue/frame/many_values.hpp"

#include <algorithm>
#include <functional>
#include <utility>

namespace parlour::dialogue {

namespace {

constexpr const char* value_key = "value";
constexpr const char* amount_key = "amount";

Value item(const Value& value, const Value& amount) {
  return Map{{value_key, value},
             {amount_key, amount.is_unknown() ? Value(1) : amount}};
}

// Whole amounts stay whole.
template <class Operation>
Value calculated(Operation operation, const Value& one, const Value& other) {
  if (one.if_integer() && other.if_integer())
    return operation(*one.if_integer(), *other.if_integer());
  return operation(one.number_or(0), other.number_or(0));
}

auto find(List& items, const Value& value) {
  return std::ranges::find_if(
      items, [&](const Value& one) { return one[value_key] == value; });
}

} // namespace

ManyValues::ManyValues(const Value& held) {
  const auto* list = held.if_list();
  if (!list)
    return;
  for (const auto& one : *list)
    items_.push_back(one.if_map() ? one : item(one, {}));
}

void ManyValues::put(const Value& value, const Value& amount, bool more) {
  const auto found = find(items_, value);
  if (found == items_.end()) {
    items_.push_back(item(value, amount));
    return;
  }
  const auto before = (*found)[amount_key];
  if (more)
    *found = item(value, calculated(std::plus(), before,
                                    amount.is_unknown() ? Value(1) : amount));
  else if (!amount.is_unknown())
    *found = item(value, amount);
}

void ManyValues::replace_last(const Value& value, const Value& amount) {
  if (!items_.empty())
    items_.pop_back();
  put(value, amount, false);
}

bool ManyValues::remove(const Value& value, const Value& amount) {
  const auto found = find(items_, value);
  if (found == items_.end())
    return false;
  const auto& held = (*found)[amount_key];
  const auto left =
      calculated(std::minus(), held.is_unknown() ? Value(1) : held, amount);
  if (amount.is_unknown() || left.number_or(0) <= 0)
    items_.erase(found);
  else
    *found = item(value, left);
  return true;
}

bool ManyValues::has(const Value& value) const {
  return std::ranges::any_of(
      items_, [&](const Value& one) { return one[value_key] == value; });
}

Value ManyValues::take() {
  return items_.empty() ? Value() : Value(std::move(items_));
}

} // namespace parlour::dialogue
