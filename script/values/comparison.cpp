// Equality and order of values (language rules 3.5 and 3.6).
#include <algorithm>
#include <cmath>

#include "script/values/operations.hpp"

namespace parlour::script {

namespace {

int sign(bool less, bool greater) {
  return less ? -1 : greater ? 1 : 0;
}

// Compares exactly: converting the integer to a double could round it.
int compare_mixed(std::int64_t integer, double number) {
  if (number >= 9223372036854775808.0)
    return -1;
  if (number < -9223372036854775808.0)
    return 1;
  // Whole parts decide first, then the fraction of the number.
  const auto whole = static_cast<std::int64_t>(number);
  if (integer != whole)
    return integer < whole ? -1 : 1;
  const auto rest = number - std::trunc(number);
  return sign(rest > 0, rest < 0);
}

// Only texts of the same length are looked into.
bool equal_texts(const StringObject& left, const StringObject& right,
                 WalkBudget& budget) {
  return left.size == right.size &&
         (&left == &right || budget.bytes(left.size)) &&
         equal_strings(left, right);
}

// Lists are equal if their elements are, one by one.
bool equal_lists(const ListObject& left, const ListObject& right,
                 WalkBudget& budget, int depth) {
  if (left.elements.size() != right.elements.size())
    return false;
  for (std::size_t i = 0; i < left.elements.size(); ++i)
    if (!equal(left.elements[i], right.elements[i], budget, depth + 1))
      return false;
  return true;
}

// The order of the entries does not matter.
bool equal_maps(const MapObject& left, MapObject& right, WalkBudget& budget,
                int depth) {
  if (left.entries.size() != right.entries.size())
    return false;
  return std::all_of(
      left.entries.begin(), left.entries.end(),
      [&](const MapObject::Entry& entry) {
        const auto& key = *entry.key.string();
        const auto* other = budget.bytes(key.size) ? right.find(key) : nullptr;
        return other && equal(entry.value, *other, budget, depth + 1);
      });
}

// Identical objects are equal without a look inside. Containers compare by
// content.
bool equal_objects(const Box& left, const Box& right, WalkBudget& budget,
                   int depth) {
  if (left.same_bits(right))
    return true;
  if (left.object()->type != right.object()->type)
    return false;
  switch (left.object()->type) {
  case ObjectType::string:
    return equal_texts(*left.string(), *right.string(), budget);
  case ObjectType::list:
    return equal_lists(*left.list(), *right.list(), budget, depth);
  case ObjectType::map:
    return equal_maps(*left.map(), *right.map(), budget, depth);
  case ObjectType::result:
  case ObjectType::binary:
    return budget.bytes(left.result()->bytes) &&
           left.result()->value == right.result()->value;
  default:
    return false; // an error equals only itself
  }
}

Failure incomparable(const Box& left, const Box& right) {
  return {ErrorKind::type,
          a_type(left) + " and " + a_type(right) + " have no order"};
}

} // namespace

// Integers and doubles are compared without rounding either of them.
int compare(const Numeric& left, const Numeric& right) {
  if (left.is_integer && right.is_integer)
    return sign(left.integer<right.integer, left.integer> right.integer);
  if (left.is_integer)
    return compare_mixed(left.integer, right.number);
  if (right.is_integer)
    return -compare_mixed(right.integer, left.number);
  return sign(left.number<right.number, left.number> right.number);
}

bool equal(const Box& left, const Box& right, WalkBudget& budget, int depth) {
  if (depth > deepest_nesting)
    budget.exhaust();
  if (!budget.values())
    return false;
  if (left.is_string() && right.is_string())
    return equal_texts(*left.string(), *right.string(), budget);
  // A string is compared as a number only with a number.
  if (!budget.bytes(digits_of(left) + digits_of(right)))
    return false;
  const auto l = numeric(left, !right.is_string());
  const auto r = l ? numeric(right) : std::nullopt;
  if (l && r && (numeric(left, false) || numeric(right, false)))
    return compare(*l, *r) == 0;
  if (left.is_object() && right.is_object())
    return equal_objects(left, right, budget, depth);
  return left.same_bits(right);
}

// Language rule 3.6: unknown has no order with anything, and that is no error;
// other mixed pairs are an error.
Outcome order(const Box& left, const Box& right, Order& result,
              WalkBudget& budget) {
  auto from_sign = [](int value) {
    return value < 0 ? Order::less : value > 0 ? Order::greater : Order::equal;
  };
  result = Order::none;
  if (left.is_unknown() || right.is_unknown())
    return {};
  if (left.is_string() && right.is_string()) {
    if (!budget.bytes(std::min(left.string()->size, right.string()->size)))
      return {};
    // Bytes of UTF-8 sort in the order of their code points.
    result = from_sign(left.text().compare(right.text()));
    return {};
  }
  if (!budget.bytes(digits_of(left) + digits_of(right)))
    return {};
  const auto l = numeric(left);
  const auto r = numeric(right);
  if (!l || !r)
    return incomparable(left, right);
  result = from_sign(compare(*l, *r));
  return {};
}

} // namespace parlour::script
