// The slow paths of the instructions: operators, containers, loops.
//
// Each charges fuel by the size of the data that it touches, so that a script
// cannot hide long work in few instructions (language rule 9.6), and checks the
// heap's limit after it has allocated.
#include <algorithm>
#include <cmath>
#include <limits>

#include "runtime/base/clock.hpp"
#include "script/vm/machine.hpp"

namespace parlour::script {

namespace {

// The bytes of a result that was made.
std::size_t bytes_of(const Box& made) {
  return made.is_string() ? made.string()->size
         : made.is_list() ? made.list()->elements.size() * sizeof(Box)
                          : 0;
}

} // namespace

// A little more than the fuel left, so that a walk that is too long uses it up.
WalkBudget Machine::walk_budget(std::size_t max_bytes) const {
  constexpr std::size_t beyond = 1000 * WalkBudget::bytes_per_instruction;
  max_bytes = std::min(max_bytes, heap_->limit());
  const auto fuel_holds = std::min<std::uint64_t>(
      fuel_left(), max_bytes / WalkBudget::bytes_per_instruction);
  return WalkBudget(fuel_holds * WalkBudget::bytes_per_instruction + beyond);
}

bool Machine::pay(const WalkBudget& budget, const char* too_much) {
  return charge(budget.price()) &&
         (!budget.exhausted() || raise(ErrorKind::limit, too_much));
}

// Texts and lists are printed or copied into the result, whose size is limited.
bool Machine::add(const Box& left, const Box& right, Box& result) {
  return check(
             script::add(*heap_, left.resolved(), right.resolved(), result)) &&
         charge_bytes(bytes_of(result)) && within_limits();
}

bool Machine::arithmetic(Arithmetic operation, const Box& left,
                         const Box& right, Box& result) {
  const auto& l = left.resolved();
  const auto& r = right.resolved();
  return charge_bytes(digits_of(l) + digits_of(r)) &&
         check(script::arithmetic(*heap_, operation, l, r, result));
}

bool Machine::negate(const Box& operand, Box& result) {
  return charge_bytes(digits_of(operand.resolved())) &&
         check(script::negate(*heap_, operand.resolved(), result));
}

bool Machine::equal(const Box& left, const Box& right, bool& result) {
  auto budget = walk_budget();
  result = script::equal(left.resolved(), right.resolved(), budget);
  return pay(budget);
}

bool Machine::order(const Box& left, const Box& right, Order& result) {
  auto budget = walk_budget();
  auto outcome =
      script::order(left.resolved(), right.resolved(), result, budget);
  return pay(budget) && check(std::move(outcome));
}

bool Machine::contained(const Box& element, const Box& container, Box& result) {
  auto budget = walk_budget();
  bool found = false;
  auto outcome = is_in(element.resolved(), container.resolved(), found, budget);
  result = Box::boolean(found);
  return pay(budget) && check(std::move(outcome));
}

// Reads or sets an element by a key that is paid for: a text is looked up or
// read as a number, and for a map any other value is printed. One that is too
// long for that stays as it is, and is refused where it is used.
bool Machine::key_for(const Box& container, const Box& key, Box& result) {
  result = container.is_map() || container.is_unknown()
               ? key_text(*heap_, key.resolved())
               : key.resolved();
  if (result.is_missing()) [[unlikely]]
    result = key.resolved();
  return charge_bytes(digits_of(result));
}

// Finding a code point means counting from the start. A cell of a result is
// converted, and so are its rows when they are first asked for.
bool Machine::get_index(const Box& container, const Box& key, Box& result) {
  const Box from = container.resolved();
  Box wanted;
  if (!charge_bytes(digits_of(from)) || !key_for(from, key, wanted))
    return false;
  Box element;
  const auto before = heap_->used();
  if (!check(script::get_index(*heap_, from, wanted, element)) ||
      !charge_made(before))
    return false;
  result = std::move(element);
  return true;
}

bool Machine::get_field(const Box& container, const Box& name, Box& result) {
  Box field;
  const auto before = heap_->used();
  if (!check(script::get_field(*heap_, container.resolved(), name, field)) ||
      !charge_made(before))
    return false;
  result = std::move(field);
  return within_limits();
}

bool Machine::set_index(const Box& container, const Box& key,
                        const Box& value) {
  Box place;
  if (!key_for(container.resolved(), key, place))
    return false;
  auto budget = walk_budget();
  auto outcome = script::set_index(*heap_, container.resolved(), place,
                                   value.resolved(), budget);
  return charge(budget.price()) && check(std::move(outcome)) && within_limits();
}

bool Machine::append(const Box& list, const Box& value) {
  auto budget = walk_budget();
  auto outcome = script::append(list.resolved(), value.resolved(), budget);
  return charge(budget.price()) && check(std::move(outcome)) && within_limits();
}

bool Machine::new_list(const Box* elements, std::size_t count, Box& result) {
  auto list = make_list(*heap_, count);
  for (std::size_t i = 0; i < count; ++i)
    list.list()->elements.push_back(elements[i].resolved());
  result = std::move(list);
  return charge_values(count) && within_limits();
}

bool Machine::new_map(const Box* pairs, std::size_t count, Box& result) {
  auto map = make_map(*heap_);
  for (std::size_t i = 0; i < count; ++i) {
    const auto& key = pairs[2 * i]; // a constant, or read from a state
    if (!key.is_string()) [[unlikely]]
      return raise(ErrorKind::type, "the key of a map must be a string, not " +
                                        a_type(key.resolved()));
    map.map()->set(key, pairs[2 * i + 1].resolved());
  }
  result = std::move(map);
  return charge_values(2 * count) && within_limits();
}

// The size is checked before anything is allocated.
bool Machine::new_array(const Box& size, Box& result) {
  const auto number = numeric(size.resolved());
  if (!number || !number->is_integer || number->integer < 0)
    return raise(ErrorKind::type, "the size of an array must be an integer "
                                  "from 0, not " +
                                      a_type(size.resolved()));
  const auto count = static_cast<std::size_t>(number->integer);
  if (count > (std::size_t{1} << 40) || !heap_->has_room(count * sizeof(Box)))
    return raise(ErrorKind::limit, "an array of " + std::to_string(count) +
                                       " elements is more than the session "
                                       "may hold");
  auto list = make_list(*heap_, count);
  list.list()->elements.resize(count);
  result = std::move(list);
  return charge_values(count);
}

// Joins the parts of a text with embedded values in one allocation.
bool Machine::concatenate(const Box* parts, std::size_t count, Box& result) {
  std::string text;
  for (std::size_t i = 0; i < count; ++i)
    if (!print(text, parts[i], heap_->limit()))
      return raise(ErrorKind::limit, "the text would be too long");
  if (!heap_->has_room(text.size()))
    return raise(ErrorKind::limit, "the text would be too long");
  result = make_string(*heap_, text);
  return charge_bytes(text.size());
}

bool Machine::milliseconds(const Box& text, Box& result) {
  std::string printed;
  print(printed, text, 1000);
  auto duration = parse_duration(printed);
  if (!duration)
    return raise(ErrorKind::type, duration.error().message);
  result = make_integer(*heap_, duration->count());
  return true;
}

// -- for (language rule 6.3) --------------------------------------------------

namespace {

// The tolerance at the end, in steps: a loop from 0 to 1 by 0.1 includes 1,
// although ten times 0.1 is not exactly 1.
constexpr double hair = 1e-9;

// The last integer that a count in integers can reach if the end is a fraction.
std::int64_t whole_end(double end, std::int64_t step) {
  end += static_cast<double>(step) * hair;
  const auto whole = step < 0 ? std::ceil(end) : std::floor(end);
  constexpr double beyond = 9223372036854775808.0; // 2^63
  return whole >= beyond   ? std::numeric_limits<std::int64_t>::max()
         : whole < -beyond ? std::numeric_limits<std::int64_t>::min()
                           : static_cast<std::int64_t>(whole);
}

// The number of rounds; 0 if the step leads away from the end. Integers are
// counted exactly, with unsigned distances, as the span may exceed 63 bits. The
// count is capped so that it fits into a small integer; no script can run that
// long.
std::int64_t iterations(const Numeric& from, Numeric to, const Numeric& step) {
  if (from.is_integer && step.is_integer) {
    if (!to.is_integer)
      to = {true, whole_end(to.number, step.integer), 0};
    if (step.integer == 0 || (step.integer > 0) != (to.integer >= from.integer))
      return to.integer == from.integer && step.integer != 0 ? 1 : 0;
    const auto distance =
        static_cast<double>(to.integer) - static_cast<double>(from.integer);
    const auto count = std::floor(distance / static_cast<double>(step.integer));
    if (count > 1e14)
      return std::int64_t{100'000'000'000'000};
    auto apart = [](std::int64_t high, std::int64_t low) {
      return static_cast<std::uint64_t>(high) - static_cast<std::uint64_t>(low);
    };
    // Exact: doubles would round long distances.
    const auto steps =
        step.integer > 0
            ? apart(to.integer, from.integer) /
                  static_cast<std::uint64_t>(step.integer)
            : apart(from.integer, to.integer) / apart(0, step.integer);
    return static_cast<std::int64_t>(steps) + 1;
  }
  const auto count =
      std::floor((to.as_number() - from.as_number()) / step.as_number() + hair);
  if (!std::isfinite(count) || count < 0)
    return 0;
  return static_cast<std::int64_t>(std::min(count, 1e14)) + 1;
}

} // namespace

// The number of rounds is computed at the start (language rule 6.3). Five
// registers control the loop:
//
//   before:  1 from      2 step   3 to
//   after:   0 left      1 current    2 step   3 from   4 variable
//
// In a loop over fractions `current` is the number of steps made.
bool Machine::for_prepare(Box* loop, bool& enters) {
  std::optional<Numeric> bounds[3];
  constexpr const char* names[] = {"from", "step", "to"};
  for (std::size_t i = 0; i < 3; ++i) {
    if (!charge_bytes(digits_of(loop[i + 1].resolved())))
      return false;
    bounds[i] = numeric(loop[i + 1].resolved());
    if (!bounds[i])
      return raise(ErrorKind::type, std::string("'") + names[i] +
                                        "' of <for> must be a number, not " +
                                        a_type(loop[i + 1].resolved()));
  }
  const auto& [from, step, to] = bounds;
  const auto count = iterations(*from, *to, *step);
  enters = count > 0;
  if (!enters)
    return true;
  auto box = [&](const Numeric& number) {
    return number.is_integer ? make_integer(*heap_, number.integer)
                             : Box::number(number.number);
  };
  loop[0] = Box::small(count - 1);
  loop[2] = box(*step);
  loop[3] = loop[4] = box(*from);
  // Fractions are computed from the number of steps, so that rounding errors do
  // not add up.
  loop[1] = from->is_integer && step->is_integer ? loop[3] : Box::number(0);
  return true;
}

// The slow path of the handler: fractions and large integers.
bool Machine::for_next(Box* loop) {
  loop[0] = Box::small(loop[0].as_small() - 1);
  if (!loop[1].is_number()) {
    const auto next = loop[1].as_integer() + loop[2].as_integer();
    loop[1] = loop[4] = make_integer(*heap_, next);
    return true;
  }
  loop[1] = Box::number(loop[1].as_number() + 1);
  const auto value = numeric(loop[3])->as_number() +
                     loop[1].as_number() * numeric(loop[2])->as_number();
  return check(number_result(value, loop[4]));
}

// The loop walks over a copy of the elements, so that changes in its body have
// no effect (language rule 6.5).
bool Machine::each_prepare(const Box& collection, Box* loop) {
  const Box from = collection.resolved();
  const auto before = heap_->used();
  Box list;
  if (from.is_list()) {
    list = make_list(*heap_, from.list()->elements.size());
    list.list()->elements = from.list()->elements;
  } else if (from.is_map()) {
    list = keys_of(*heap_, *from.map());
  } else if (from.is(ObjectType::result)) {
    const Box rows = rows_of(*heap_, from);
    list = make_list(*heap_);
    list.list()->elements = rows.list()->elements;
  } else if (from.is_string()) {
    list = make_list(*heap_, from.string()->code_points);
    const auto text = from.text();
    for (std::size_t at = 0; at < text.size();) {
      const auto size = character_size(text[at]);
      list.list()->elements.push_back(
          make_string(*heap_, text.substr(at, size)));
      at += size;
    }
  } else if (from.is_unknown()) {
    list = make_list(*heap_);
  } else {
    return raise(ErrorKind::type,
                 "<for each> cannot walk over " + a_type(from));
  }
  const bool paid = charge_made(before);
  loop[0] = std::move(list);
  loop[1] = Box::small(0);
  return paid && within_limits();
}

} // namespace parlour::script
