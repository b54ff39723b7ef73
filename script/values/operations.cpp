// Operators in the slow but complete form. The interpreter has inline fast
// paths for small integers and doubles (script/vm/handlers_values.hpp) and
// comes here for everything else: large integers, strings, lists, errors.

#include "script/values/operations.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace parlour::script {

namespace {

Failure type_failure(std::string message) {
  return {ErrorKind::type, std::move(message)};
}

constexpr std::array<const char*, 4> symbols{"-", "*", "/", "%"};

// Names the side that is wrong; the left one if both are.
Failure operand_failure(const char* symbol, const Box& left, const Box& right) {
  const bool left_wrong = !numeric(left);
  return type_failure(std::string("'") + symbol + "' needs numbers, but its " +
                      (left_wrong ? "left" : "right") + " side is " +
                      a_type(left_wrong ? left : right));
}

Failure division_by_zero() {
  return {ErrorKind::arithmetic, "division by zero"};
}

// An exact division gives an integer, any other a number (language rule 3.8).
Outcome divide_integers(Heap& heap, std::int64_t left, std::int64_t right,
                        Box& result) {
  if (right == 0)
    return division_by_zero();
  if (right == -1) // the smallest has no opposite
    return negate(heap, make_integer(heap, left), result);
  if (left % right == 0)
    result = make_integer(heap, left / right);
  else
    result =
        Box::number(static_cast<double>(left) / static_cast<double>(right));
  return {};
}

// The remainder has the sign of the right side (language rule 3.8), while C++
// gives it the sign of the left side.
Outcome modulo_integers(Heap& heap, std::int64_t left, std::int64_t right,
                        Box& result) {
  if (right == 0)
    return division_by_zero();
  auto rest = right == -1 ? 0 : left % right;
  if (rest != 0 && (rest < 0) != (right < 0))
    rest += right;
  result = make_integer(heap, rest);
  return {};
}

Outcome modulo_numbers(double left, double right, Box& result) {
  if (right == 0)
    return division_by_zero();
  auto rest = std::fmod(left, right);
  if (rest != 0 && (rest < 0) != (right < 0))
    rest += right;
  return number_result(rest, result);
}

// If the result overflows, it is computed again in doubles.
Outcome integers(Heap& heap, Arithmetic operation, std::int64_t left,
                 std::int64_t right, Box& result) {
  std::int64_t value = 0;
  const auto l = static_cast<double>(left);
  const auto r = static_cast<double>(right);
  switch (operation) {
  case Arithmetic::subtract:
    if (__builtin_sub_overflow(left, right, &value))
      return number_result(l - r, result);
    break;
  case Arithmetic::multiply:
    if (__builtin_mul_overflow(left, right, &value))
      return number_result(l * r, result);
    break;
  case Arithmetic::divide:
    return divide_integers(heap, left, right, result);
  case Arithmetic::modulo:
    return modulo_integers(heap, left, right, result);
  }
  result = make_integer(heap, value);
  return {};
}

// Arithmetic on doubles; a result that is not finite is an error.
Outcome numbers(Arithmetic operation, double left, double right, Box& result) {
  switch (operation) {
  case Arithmetic::subtract:
    return number_result(left - right, result);
  case Arithmetic::multiply:
    return number_result(left * right, result);
  case Arithmetic::divide:
    if (right == 0)
      return division_by_zero();
    return number_result(left / right, result);
  case Arithmetic::modulo:
    return modulo_numbers(left, right, result);
  }
  return {};
}

Outcome add_numbers(Heap& heap, const Numeric& left, const Numeric& right,
                    Box& result) {
  std::int64_t sum = 0;
  if (left.is_integer && right.is_integer &&
      !__builtin_add_overflow(left.integer, right.integer, &sum)) {
    result = make_integer(heap, sum);
    return {};
  }
  return number_result(left.as_number() + right.as_number(), result);
}

Outcome too_large(Heap& heap) {
  return Failure{ErrorKind::limit,
                 "the session's values would hold more than " +
                     std::to_string(heap.limit()) + " bytes"};
}

// The printed form of a value. A string is not copied and a small integer needs
// no allocation, since these are what a script joins most of the time.
class Printed {
public:
  Printed(const Box& box, std::size_t limit) {
    if (box.is_string()) {
      text_ = box.text();
      code_points_ = box.string()->code_points;
      fits_ = text_.size() <= limit;
    } else if (box.is_small()) {
      const auto end =
          std::to_chars(digits_.begin(), digits_.end(), box.as_small()).ptr;
      text_ = {digits_.data(), static_cast<std::size_t>(end - digits_.data())};
      code_points_ = static_cast<std::uint32_t>(text_.size());
    } else {
      fits_ = print(longer_, box, limit);
      text_ = longer_;
      code_points_ = count_code_points(text_);
    }
  }
  Printed(const Printed&) = delete;
  Printed& operator=(const Printed&) = delete;

  bool fits() const {
    return fits_;
  }
  std::string_view text() const {
    return text_;
  }
  std::uint32_t code_points() const {
    return code_points_;
  }

private:
  std::array<char, 24> digits_;
  std::string longer_;
  std::string_view text_;
  std::uint32_t code_points_ = 0;
  bool fits_ = true;
};

// The size is known before the string is allocated, so it is written once.
Outcome join(Heap& heap, const Box& left, const Box& right, Box& result) {
  const Printed first(left, heap.limit());
  const Printed second(right, heap.limit());
  const auto size = first.text().size() + second.text().size();
  if (!first.fits() || !second.fits() || !heap.has_room(size))
    return too_large(heap);
  auto* string = raw_string(heap, size);
  auto* end =
      std::copy(first.text().begin(), first.text().end(), string->data());
  std::copy(second.text().begin(), second.text().end(), end);
  result = finish_string(string, first.code_points() + second.code_points());
  return {};
}

// A new list; the elements are shared.
Outcome join_lists(Heap& heap, const ListObject& left, const ListObject& right,
                   Box& result) {
  const auto size = left.elements.size() + right.elements.size();
  if (!heap.has_room(size * sizeof(Box)))
    return too_large(heap);
  auto list = make_list(heap, size);
  auto& elements = list.list()->elements;
  elements.insert(elements.end(), left.elements.begin(), left.elements.end());
  elements.insert(elements.end(), right.elements.begin(), right.elements.end());
  result = std::move(list);
  return {};
}

} // namespace

std::string_view type_name(const Box& box) {
  if (box.is_unknown())
    return "unknown";
  if (box.is_boolean())
    return "boolean";
  if (box.is_number())
    return "number";
  if (box.is_small())
    return "integer";
  constexpr std::array<std::string_view, 7> names{
      "string", "list", "map", "result", "binary", "error", "integer"};
  return names[static_cast<std::size_t>(box.object()->type)];
}

// The type with its article, for messages: "an integer".
std::string a_type(const Box& box) {
  if (box.is_unknown())
    return "unknown";
  const auto name = type_name(box);
  const bool vowel = name == "integer" || name == "error";
  return (vowel ? "an " : "a ") + std::string(name);
}

// Numbers, then objects by their content; binaries and errors count as true.
bool truth(const Box& box) {
  if (box.is_boolean())
    return box.is_true();
  if (box.is_number())
    return box.as_number() != 0;
  if (box.is_small())
    return box.as_small() != 0;
  if (!box.is_object())
    return false;
  switch (box.object()->type) {
  case ObjectType::string:
    return box.string()->size > 0;
  case ObjectType::list:
    return !box.list()->elements.empty();
  case ObjectType::map:
    return !box.map()->entries.empty();
  case ObjectType::result:
    return static_cast<bool>(box.result()->value);
  default:
    return true;
  }
}

// The most frequent kinds come first.
std::optional<Numeric> numeric(const Box& box, bool from_text) {
  if (box.is_small())
    return Numeric{true, box.as_small(), 0};
  if (box.is_number())
    return Numeric{false, 0, box.as_number()};
  if (box.is(ObjectType::integer))
    return Numeric{true, box.as_integer(), 0};
  if (!from_text || !box.is_string())
    return {};
  const auto value = parse_number(box.text());
  if (const auto* integer = value.if_integer())
    return Numeric{true, *integer, 0};
  if (const auto* number = value.if_number(); number && std::isfinite(*number))
    return Numeric{false, 0, *number};
  return {};
}

std::size_t digits_of(const Box& box) {
  return box.is_string() ? box.string()->size : 0;
}

Outcome number_result(double value, Box& result) {
  if (!std::isfinite(value))
    return Failure{ErrorKind::arithmetic, "the result is too large"};
  result = Box::number(value);
  return {};
}

Outcome arithmetic(Heap& heap, Arithmetic operation, const Box& left,
                   const Box& right, Box& result) {
  const auto l = numeric(left);
  const auto r = numeric(right);
  if (!l || !r)
    return operand_failure(symbols[static_cast<std::size_t>(operation)], left,
                           right);
  if (l->is_integer && r->is_integer)
    return integers(heap, operation, l->integer, r->integer, result);
  return numbers(operation, l->as_number(), r->as_number(), result);
}

// A string on either side joins texts; two lists make a new list; everything
// else must be numbers (language rule 3.7).
Outcome add(Heap& heap, const Box& left, const Box& right, Box& result) {
  if (left.is_string() || right.is_string())
    return join(heap, left, right, result);
  if (left.is_list() && right.is_list())
    return join_lists(heap, *left.list(), *right.list(), result);
  const auto l = numeric(left);
  const auto r = numeric(right);
  if (l && r)
    return add_numbers(heap, *l, *r, result);
  return type_failure("'+' cannot add " + a_type(left) + " and " +
                      a_type(right));
}

// As 0 - operand, so the smallest integer becomes a number.
Outcome negate(Heap& heap, const Box& operand, Box& result) {
  const auto number = numeric(operand);
  if (!number)
    return type_failure("'-' needs a number, not " + a_type(operand));
  return number->is_integer
             ? integers(heap, Arithmetic::subtract, 0, number->integer, result)
             : number_result(-number->number, result);
}

// -- printing -----------------------------------------------------------------

namespace {

bool print_list(std::string& text, const ListObject& list, std::size_t limit,
                int depth) {
  text += '[';
  const char* separator = "";
  for (const auto& element : list.elements) {
    text += separator;
    separator = ", ";
    if (!print(text, element, limit, depth + 1))
      return false;
  }
  text += ']';
  return true;
}

bool print_map(std::string& text, const MapObject& map, std::size_t limit,
               int depth) {
  text += '{';
  const char* separator = "";
  for (const auto& entry : map.entries) {
    text += separator;
    separator = ", ";
    text += entry.key.text();
    text += ": ";
    if (!print(text, entry.value, limit, depth + 1))
      return false;
  }
  text += '}';
  return true;
}

// A string inside of a container is printed without quotes.
bool print_object(std::string& text, const Box& box, std::size_t limit,
                  int depth) {
  switch (box.object()->type) {
  case ObjectType::string:
    if (box.string()->size > limit)
      return false;
    text += box.text();
    return true;
  case ObjectType::list:
    return print_list(text, *box.list(), limit, depth);
  case ObjectType::map:
    return print_map(text, *box.map(), limit, depth);
  case ObjectType::integer:
    text += std::to_string(box.as_integer());
    return true;
  case ObjectType::error:
    text += box.error()->message;
    return true;
  default:
    text += to_string(box.result()->value);
    return true;
  }
}

} // namespace

// Checks the limit between elements, so the text exceeds it by one element at
// most.
bool print(std::string& text, const Box& box, std::size_t limit, int depth) {
  if (text.size() > limit || depth > deepest_nesting)
    return false;
  if (box.is_object())
    return print_object(text, box, limit, depth) && text.size() <= limit;
  if (box.is_small())
    text += std::to_string(box.as_small());
  else if (box.is_number())
    text += number_text(box.as_number());
  else if (box.is_boolean())
    text += box.is_true() ? "true" : "false";
  else if (box.is_reference())
    return print(text, *box.target(), limit, depth);
  else
    text += "unknown";
  return true;
}

} // namespace parlour::script
