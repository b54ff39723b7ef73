// Built-in functions for numbers and types (language rules 8.7 and 8.9).
#include <algorithm>
#include <cmath>

#include "script/vm/builtin_call.hpp"
#include "script/vm/builtin_functions.hpp"

namespace parlour::script::builtins {

namespace {

// The value as an integer if it fits, else as a number.
bool give_whole(BuiltinCall& call, double value) {
  if (value >= -9223372036854775808.0 && value < 9223372036854775808.0)
    return call.give_integer(static_cast<std::int64_t>(value));
  return call.give_number(value);
}

// floor, ceil and round: integers stay as they are.
bool rounded(BuiltinCall& call, double (*round)(double)) {
  Numeric value;
  if (!call.number(0, value))
    return false;
  if (value.is_integer)
    return call.give_integer(value.integer);
  return give_whole(call, round(value.number));
}

// min (sign -1) and max (sign 1), of the arguments or of a single list. Two
// small integers are the most frequent case.
bool extreme(BuiltinCall& call, int sign) {
  if (call.count == 2 && Box::both_small(call[0], call[1])) {
    const bool less = call[0].as_small() < call[1].as_small();
    return call.give(call[less == (sign < 0) ? 0 : 1]);
  }
  const Box* begin = call.arguments;
  auto count = call.count;
  ListObject* list = nullptr;
  if (count == 1) {
    if (!call.list(0, list))
      return false;
    begin = list->elements.data();
    count = list->elements.size();
  }
  const Box* best = nullptr;
  for (std::size_t i = 0; i < count; ++i) {
    if (begin[i].is_unknown() || (!begin[i].is_string() && !numeric(begin[i])))
      return call.fail(ErrorKind::type, "only numbers or strings have an order,"
                                        " not " +
                                            a_type(begin[i]));
    Order found = Order::none;
    if (best && !call.machine.order(begin[i], *best, found))
      return false;
    if (!best || found == (sign < 0 ? Order::less : Order::greater))
      best = &begin[i];
  }
  return call.give(best ? *best : Box());
}

} // namespace

// The smallest integer has no opposite, so negative values take the operator's
// way, which makes it a number.
bool absolute(BuiltinCall& call) {
  Numeric value;
  if (!call.number(0, value))
    return false;
  const bool negative = value.as_number() < 0;
  return negative
             ? call.machine.check(negate(call.heap(), call[0], call.result))
         : value.is_integer ? call.give_integer(value.integer)
                            : call.give_number(value.number);
}

bool minimum(BuiltinCall& call) {
  return extreme(call, -1);
}

bool maximum(BuiltinCall& call) {
  return extreme(call, 1);
}

bool floor(BuiltinCall& call) {
  return rounded(call, std::floor);
}

bool ceil(BuiltinCall& call) {
  return rounded(call, std::ceil);
}

bool round(BuiltinCall& call) {
  return rounded(call, std::round);
}

// The result is always a number with a fraction, also for perfect squares: it
// prints as an integer all the same.
bool square_root(BuiltinCall& call) {
  Numeric value;
  if (!call.number(0, value))
    return false;
  if (value.as_number() < 0)
    return call.fail(ErrorKind::arithmetic, "a negative number has no root");
  return call.give_number(std::sqrt(value.as_number()));
}

namespace {

// Exponentiation by squaring; nothing if the result does not fit into 64 bits.
std::optional<std::int64_t> integer_power(std::int64_t base,
                                          std::int64_t exponent) {
  std::int64_t result = 1;
  for (; exponent > 0; exponent >>= 1) {
    if ((exponent & 1) && __builtin_mul_overflow(result, base, &result))
      return {};
    if (exponent > 1 && __builtin_mul_overflow(base, base, &base))
      return {};
  }
  return result;
}

} // namespace

// Integers stay exact as long as they fit; otherwise doubles are used.
bool power(BuiltinCall& call) {
  Numeric base;
  Numeric exponent;
  if (!call.number(0, base) || !call.number(1, exponent))
    return false;
  if (base.is_integer && exponent.is_integer && exponent.integer >= 0)
    if (const auto value = integer_power(base.integer, exponent.integer))
      return call.give_integer(*value);
  const auto value = std::pow(base.as_number(), exponent.as_number());
  if (!std::isfinite(value))
    return call.fail(ErrorKind::arithmetic, "the result is not a number");
  return call.give_number(value);
}

// Both ends are included. The range may span more than 63 bits, so the offset
// is added unsigned.
bool random(BuiltinCall& call) {
  const auto chance = call.machine.host->random();
  if (call.count == 0)
    return call.give_number(chance);
  std::int64_t from = 0;
  std::int64_t to = 0;
  if (!call.has(1))
    return call.fail(ErrorKind::type, "give both ends, or none");
  if (!call.integer(0, from) || !call.integer(1, to))
    return false;
  if (from > to)
    return call.fail(ErrorKind::range, "the first end is above the second");
  // As doubles, since the number of possible results may exceed 64 bits.
  const auto size = static_cast<double>(to) - static_cast<double>(from) + 1;
  const auto offset =
      static_cast<std::int64_t>(std::min(std::floor(chance * size), 9.2e18));
  return call.give_integer(std::min(
      to, static_cast<std::int64_t>(static_cast<std::uint64_t>(from) +
                                    static_cast<std::uint64_t>(offset))));
}

// The number that a text is written like; unknown for other texts (language
// rule 8.7).
bool number(BuiltinCall& call) {
  std::optional<Numeric> value;
  if (!call.perhaps_number(0, value))
    return false;
  if (!value)
    return call.give(Box());
  return value->is_integer ? call.give_integer(value->integer)
                           : call.give_number(value->number);
}

// The same, cut towards zero.
bool integer(BuiltinCall& call) {
  std::optional<Numeric> value;
  if (!call.perhaps_number(0, value))
    return false;
  if (!value)
    return call.give(Box());
  return value->is_integer ? call.give_integer(value->integer)
                           : give_whole(call, std::trunc(value->number));
}

bool type(BuiltinCall& call) {
  return call.give_text(std::string(type_name(call[0])));
}

bool is_known(BuiltinCall& call) {
  return call.give_flag(!call[0].is_unknown());
}

// Whether a remote agent is connected; the host knows.
bool online(BuiltinCall& call) {
  std::string agent;
  return call.text(0, agent) &&
         call.give_flag(call.machine.host->online(agent));
}

} // namespace parlour::script::builtins
