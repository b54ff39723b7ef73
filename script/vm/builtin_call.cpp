// Arguments of built-in functions: conversions, errors and limits.

#include "script/vm/builtin_call.hpp"

#include <utility>

namespace parlour::script {

// Each message begins with the function's name (language rule 8.1).
bool BuiltinCall::fail(ErrorKind kind, const std::string& message) {
  return machine.raise(kind, std::string(name) + ": " + message);
}

bool BuiltinCall::wrong_type(std::size_t index, const char* wanted) {
  return fail(ErrorKind::type, "argument " + std::to_string(index + 1) +
                                   " must be " + wanted + ", not " +
                                   a_type(arguments[index]));
}

// Lists, maps and the like are not converted: their printed form is hardly ever
// what was meant.
bool BuiltinCall::text(std::size_t index, std::string& value) {
  const auto& box = arguments[index];
  if (!box.is_string() && !box.is_boolean() && !numeric(box, false))
    return wrong_type(index, "a string");
  value.clear();
  script::print(value, box, heap().limit());
  return bytes(value.size());
}

// The argument's register keeps the new string alive during the call.
const StringObject* BuiltinCall::string(std::size_t index) {
  auto& argument = arguments[index];
  if (argument.is_string()) {
    const auto* string = argument.string();
    return bytes(string->size) ? string : nullptr;
  }
  std::string printed;
  if (!text(index, printed))
    return nullptr;
  argument = make_string(heap(), printed);
  return argument.string();
}

bool BuiltinCall::perhaps_number(std::size_t index,
                                 std::optional<Numeric>& value) {
  value = numeric(arguments[index]);
  return bytes(digits_of(arguments[index]));
}

bool BuiltinCall::number(std::size_t index, Numeric& value) {
  std::optional<Numeric> found;
  if (!perhaps_number(index, found))
    return false;
  if (!found)
    return wrong_type(index, "a number");
  value = *found;
  return true;
}

// Numbers without a fraction count as integers.
bool BuiltinCall::integer(std::size_t index, std::int64_t& value) {
  if (arguments[index].is_small()) {
    value = arguments[index].as_small();
    return true;
  }
  std::optional<Numeric> found;
  if (!perhaps_number(index, found))
    return false;
  if (!found)
    return wrong_type(index, "an integer");
  if (!found->is_integer) {
    const auto whole =
        static_cast<double>(found->number < 9e15 && found->number > -9e15
                                ? static_cast<std::int64_t>(found->number)
                                : 0);
    if (whole != found->number)
      return wrong_type(index, "an integer");
    found->integer = static_cast<std::int64_t>(whole);
  }
  value = found->integer;
  return true;
}

// The elements count as work, since almost every function visits them.
bool BuiltinCall::list(std::size_t index, ListObject*& value) {
  if (!arguments[index].is_list())
    return wrong_type(index, "a list");
  value = arguments[index].list();
  return values(value->elements.size());
}

bool BuiltinCall::print(std::string& text, const Box& value) {
  const auto limit = machine.program->settings.limits.result;
  const auto before = text.size();
  if (!script::print(text, value, limit))
    return room(limit + 1);
  return bytes(text.size() - before);
}

bool BuiltinCall::pay(const WalkBudget& budget) {
  return machine.charge(budget.price()) &&
         (!budget.exhausted() || fail(ErrorKind::limit, "too much to compare"));
}

// Two limits: of a single result, and of all values of the session.
bool BuiltinCall::room(std::size_t bytes) {
  const auto limit = machine.program->settings.limits.result;
  if (bytes > limit)
    return fail(ErrorKind::limit, "the result would be larger than " +
                                      std::to_string(limit) + " bytes");
  if (!heap().has_room(bytes))
    return fail(ErrorKind::limit, "the session's values would hold more than " +
                                      std::to_string(heap().limit()) +
                                      " bytes");
  return true;
}

bool BuiltinCall::give(Box value) {
  result = std::move(value);
  return true;
}

bool BuiltinCall::give_text(const std::string& value) {
  return room(value.size()) && bytes(value.size()) &&
         give(make_string(heap(), value));
}

bool BuiltinCall::give_integer(std::int64_t value) {
  return give(make_integer(heap(), value));
}

// Infinite results are errors (language rule 2.5).
bool BuiltinCall::give_number(double value) {
  return machine.check(number_result(value, result));
}

bool BuiltinCall::give_flag(bool value) {
  return give(Box::boolean(value));
}

} // namespace parlour::script
