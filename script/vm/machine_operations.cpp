// The slow ways of the instructions: operators, containers, loops.
#include <algorithm>
#include <cmath>
#include <limits>

#include "runtime/base/clock.hpp"
#include "script/vm/machine.hpp"

namespace parlour::script {

namespace {

// Work of this many bytes counts as one instruction.
constexpr std::size_t bytes_per_unit = 32;

std::size_t size_of(const Box& box) {
  return box.is_string() ? box.string()->size / bytes_per_unit
         : box.is_list() ? box.list()->elements.size()
                         : 0;
}

// What is no text is printed to be a key.
std::size_t key_size(const Box& key) {
  if (!key.is_object() || key.is_string())
    return size_of(key);
  std::string printed;
  print(printed, key, 1 << 20);
  return 2 * printed.size() / bytes_per_unit;
}

} // namespace

bool Machine::add(const Box& left, const Box& right, Box& result) {
  const auto& l = left.resolved();
  const auto& r = right.resolved();
  return charge(size_of(l) + size_of(r)) &&
         check(script::add(*heap_, l, r, result)) && within_limits();
}

bool Machine::arithmetic(Arithmetic operation, const Box& left,
                         const Box& right, Box& result) {
  const auto& l = left.resolved();
  const auto& r = right.resolved();
  return charge(size_of(l) + size_of(r)) &&
         check(script::arithmetic(*heap_, operation, l, r, result));
}

bool Machine::negate(const Box& operand, Box& result) {
  return charge(size_of(operand.resolved())) &&
         check(script::negate(*heap_, operand.resolved(), result));
}

bool Machine::equal(const Box& left, const Box& right, bool& result) {
  const auto& l = left.resolved();
  const auto& r = right.resolved();
  // A text may be a number.
  if (l.is_string() != r.is_string() && !charge(size_of(l.is_string() ? l : r)))
    return false;
  auto budget = walk_budget();
  const auto before = budget;
  result = script::equal(l, r, budget);
  return budget == 0 ? raise(ErrorKind::limit, "too much to compare")
                     : charge((before - budget) / 2);
}

bool Machine::order(const Box& left, const Box& right, Order& result) {
  const auto& l = left.resolved();
  const auto& r = right.resolved();
  return charge(std::min(size_of(l), size_of(r))) &&
         check(script::order(l, r, result));
}

bool Machine::contained(const Box& element, const Box& container, Box& result) {
  auto budget = walk_budget();
  const auto before = budget;
  bool found = false;
  const auto& within = container.resolved();
  if (!within.is_list() && !charge(key_size(element.resolved())))
    return false;
  auto outcome = is_in(element.resolved(), within, found, budget);
  result = Box::boolean(found);
  if (budget == 0)
    return raise(ErrorKind::limit, "too much to compare");
  return check(std::move(outcome)) &&
         charge(before - budget + (within.is_string() ? size_of(within) : 0));
}

bool Machine::get_index(const Box& container, const Box& key, Box& result) {
  const auto& from = container.resolved();
  // A code point's place is found by counting.
  if (from.is_string() && !charge(size_of(from)))
    return false;
  return charge(key_size(key.resolved())) &&
         check(script::get_index(*heap_, from, key.resolved(), result));
}

bool Machine::get_field(const Box& container, const Box& name, Box& result) {
  const Box from = container.resolved();
  return check(script::get_field(*heap_, from, name, result)) &&
         within_limits();
}

bool Machine::set_index(const Box& container, const Box& key,
                        const Box& value) {
  std::size_t work = 0;
  return charge(key_size(key.resolved())) &&
         check(script::set_index(*heap_, container.resolved(), key.resolved(),
                                 value.resolved(), work)) &&
         charge(work / boxes_per_unit) && within_limits();
}

bool Machine::append(const Box& list, const Box& value) {
  std::size_t work = 0;
  return check(script::append(list.resolved(), value.resolved(), work)) &&
         charge(work / boxes_per_unit) && within_limits();
}

bool Machine::new_list(const Box* elements, std::size_t count, Box& result) {
  auto list = make_list(*heap_, count);
  for (std::size_t i = 0; i < count; ++i)
    list.list()->elements.push_back(elements[i].resolved());
  result = std::move(list);
  return charge(count) && within_limits();
}

bool Machine::new_map(const Box* pairs, std::size_t count, Box& result) {
  auto map = make_map(*heap_);
  for (std::size_t i = 0; i < count; ++i) {
    const auto& key = pairs[2 * i]; // a constant, or what a state had there
    if (!key.is_string()) [[unlikely]]
      return raise(ErrorKind::type, "the key of a map must be a string, not " +
                                        a_type(key.resolved()));
    map.map()->set(key, pairs[2 * i + 1].resolved());
  }
  result = std::move(map);
  return charge(count) && within_limits();
}

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
  return charge(count);
}

bool Machine::concatenate(const Box* parts, std::size_t count, Box& result) {
  std::string text;
  for (std::size_t i = 0; i < count; ++i)
    if (!print(text, parts[i], heap_->limit()))
      return raise(ErrorKind::limit, "the text would be too long");
  if (!heap_->has_room(text.size()))
    return raise(ErrorKind::limit, "the text would be too long");
  result = make_string(*heap_, text);
  return charge(text.size() / bytes_per_unit);
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

// -- for (language rule 6.3): the number of iterations is known at the start --

namespace {

// The tolerance of the end, in steps: 0 to 1 by 0.1 includes 1.
constexpr double hair = 1e-9;

// The last integer that a fraction lets an integer count reach.
std::int64_t whole_end(double end, std::int64_t step) {
  end += static_cast<double>(step) * hair;
  const auto whole = step < 0 ? std::ceil(end) : std::floor(end);
  constexpr double beyond = 9223372036854775808.0; // 2^63
  return whole >= beyond   ? std::numeric_limits<std::int64_t>::max()
         : whole < -beyond ? std::numeric_limits<std::int64_t>::min()
                           : static_cast<std::int64_t>(whole);
}

// How often; 0 where it never arrives.
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

bool Machine::for_prepare(Box* loop, bool& enters) {
  // In: 1 from, 2 step, 3 to.
  std::optional<Numeric> bounds[3];
  constexpr const char* names[] = {"from", "step", "to"};
  for (std::size_t i = 0; i < 3; ++i) {
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
  // Fractions count steps, so that they do not drift.
  loop[1] = from->is_integer && step->is_integer ? loop[3] : Box::number(0);
  return true;
}

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

bool Machine::each_prepare(const Box& collection, Box* loop) {
  const Box from = collection.resolved();
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
  const auto size = list.list()->elements.size();
  loop[0] = std::move(list);
  loop[1] = Box::small(0);
  return charge(size) && within_limits();
}

} // namespace parlour::script
