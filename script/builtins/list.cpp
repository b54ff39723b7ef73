// Built-in functions for lists, maps and results (language rules 8.4 to 8.6).
// Each charges fuel for the elements that it visits or copies.
#include <algorithm>
#include <bit>

#include "script/values/convert.hpp"
#include "script/vm/builtin_call.hpp"
#include "script/vm/builtin_functions.hpp"

namespace parlour::script::builtins {

// Characters, elements, entries or rows; 0 for unknown (language rule 8.11).
bool length(BuiltinCall& call) {
  const auto& box = call[0];
  if (box.is_unknown())
    return call.give_integer(0);
  if (box.is_string())
    return call.give_integer(box.string()->code_points);
  if (box.is_list())
    return call.give_integer(
        static_cast<std::int64_t>(box.list()->elements.size()));
  if (box.is_map())
    return call.give_integer(
        static_cast<std::int64_t>(box.map()->entries.size()));
  if (box.is(ObjectType::result))
    return call.give_integer(static_cast<std::int64_t>(
        box.result()->value.if_result()->row_count()));
  std::string text; // numbers and booleans as text
  return call.text(0, text) &&
         call.give_integer(static_cast<std::int64_t>(text.size()));
}

// The same as the operator `in`, with the sides exchanged.
bool contains(BuiltinCall& call) {
  if (!call[0].is_unknown() && !call[0].is_object())
    return call.wrong_type(0, "a string, list or map");
  auto budget = call.machine.walk_budget();
  bool found = false;
  auto outcome = is_in(call[1], call[0], found, budget);
  if (!call.pay(budget))
    return false;
  if (outcome && outcome->kind == ErrorKind::limit)
    return call.machine.raise(std::move(*outcome));
  return outcome ? call.wrong_type(0, "a string, list or map")
                 : call.give_flag(found);
}

// Changes the list in place and returns it (language rule 8.4).
bool append(BuiltinCall& call) {
  if (!call[0].is_list())
    return call.wrong_type(0, "a list");
  call.changes();
  return call.machine.append(call[0], call[1]) && call.give(call[0]);
}

// The position may be the size of the list: then it appends.
bool insert(BuiltinCall& call) {
  ListObject* list = nullptr;
  std::int64_t at = 0;
  if (!call.list(0, list) || !call.integer(1, at))
    return false;
  const auto size = static_cast<std::int64_t>(list->elements.size());
  if (at < 0)
    at += size;
  if (at < 0 || at > size)
    return call.fail(ErrorKind::range, "position " + std::to_string(at) +
                                           " is outside of a list of " +
                                           std::to_string(size));
  auto budget = call.machine.walk_budget();
  auto ring = refuse_ring(call[0], call[2], budget);
  if (!call.machine.charge(budget.price()) ||
      !call.machine.check(std::move(ring)) ||
      !call.values(list->elements.size()))
    return false;
  call.changes();
  list->elements.insert(list->elements.begin() + at, call[2]);
  return call.give(call[0]);
}

// Removes a key of a map or a position of a list, and returns the value.
bool remove(BuiltinCall& call) {
  Box removed;
  call.changes();
  if (call[0].is_map()) {
    std::string key;
    return call.text(1, key) && call.values(call[0].map()->entries.size()) &&
           (call[0].map()->remove(key, removed), call.give(removed));
  }
  ListObject* list = nullptr;
  std::int64_t position = 0;
  if (!call.list(0, list) || !call.integer(1, position))
    return false;
  const auto at = place_in(position, list->elements.size());
  if (!at)
    return call.fail(ErrorKind::range,
                     "position " + std::to_string(position) +
                         " is outside of a list of " +
                         std::to_string(list->elements.size()));
  if (!call.values(list->elements.size())) // those behind it move
    return false;
  removed = list->elements[*at];
  list->elements.erase(list->elements.begin() +
                       static_cast<std::ptrdiff_t>(*at));
  return call.give(std::move(removed));
}

namespace {

// The fast path for lists of small integers, which are the most frequent. Equal
// integers cannot be told apart, so the sort need not be stable.
bool sort_integers(Boxes& elements, bool descending) {
  if (!std::all_of(elements.begin(), elements.end(),
                   [](const Box& box) { return box.is_small(); }))
    return false;
  std::vector<std::int64_t> integers;
  integers.reserve(elements.size());
  for (const auto& element : elements)
    integers.push_back(element.as_small());
  std::sort(integers.begin(), integers.end());
  if (descending)
    std::reverse(integers.begin(), integers.end());
  for (std::size_t i = 0; i < integers.size(); ++i)
    elements[i].set_uncounted(Box::small(integers[i]));
  return true;
}

// Each element is compared about log2(n) times.
bool charge_sort(BuiltinCall& call, const Boxes& elements) {
  std::size_t bytes = elements.size() * WalkBudget::bytes_per_value;
  for (const auto& element : elements)
    bytes += digits_of(element);
  return call.bytes(bytes * std::bit_width(elements.size()));
}

} // namespace

// Sorts in place, and stably. The elements must be all numbers or all strings
// (language rule 8.5).
bool sort(BuiltinCall& call) {
  ListObject* list = nullptr;
  std::string direction;
  if (!call.list(0, list) || (call.has(1) && !call.text(1, direction)))
    return false;
  auto& elements = list->elements;
  // Sorting starts only when all elements are known to be comparable.
  const auto all = [&](auto is) {
    return std::all_of(elements.begin(), elements.end(), is);
  };
  const bool numbers = all([](const Box& b) { return !!numeric(b, false); });
  if (!numbers && !all([](const Box& b) { return b.is_string(); }))
    return call.fail(ErrorKind::type, "only numbers with numbers or strings "
                                      "with strings can be sorted");
  if (!direction.empty() && direction != "descending" &&
      direction != "ascending")
    return call.fail(ErrorKind::type, "the order is 'ascending' or "
                                      "'descending', not '" +
                                          direction + "'");
  if (!charge_sort(call, elements))
    return false;
  call.changes();
  if (sort_integers(elements, direction == "descending"))
    return call.give(call[0]);
  auto before = [&](const Box& a, const Box& b) {
    return numbers ? compare(*numeric(a), *numeric(b)) < 0
                   : a.text() < b.text();
  };
  if (direction == "descending")
    std::stable_sort(elements.begin(), elements.end(),
                     [&](const Box& a, const Box& b) { return before(b, a); });
  else
    std::stable_sort(elements.begin(), elements.end(), before);
  return call.give(call[0]);
}

// In place, like sort.
bool reverse(BuiltinCall& call) {
  ListObject* list = nullptr;
  if (!call.list(0, list) || !call.values(list->elements.size()))
    return false;
  call.changes();
  std::reverse(list->elements.begin(), list->elements.end());
  return call.give(call[0]);
}

// Compares like ==.
bool index_of(BuiltinCall& call) {
  ListObject* list = nullptr;
  if (call[0].is_unknown())
    return call.give_integer(-1);
  if (!call.list(0, list))
    return false;
  auto budget = call.machine.walk_budget();
  const auto& elements = list->elements;
  const auto found =
      std::find_if(elements.begin(), elements.end(), [&](const Box& element) {
        return equal(element, call[1], budget) || budget.exhausted();
      });
  return call.pay(budget) &&
         call.give_integer(found == elements.end() ? -1
                                                   : found - elements.begin());
}

// A part of a list or string, `from` included and `to` excluded. Positions
// outside are moved to the ends.
bool slice(BuiltinCall& call) {
  const auto& box = call[0];
  if (!box.is_list() && !box.is_string())
    return call.wrong_type(0, "a list or string");
  const auto size = static_cast<std::int64_t>(
      box.is_list() ? box.list()->elements.size() : box.string()->code_points);
  std::int64_t from = 0;
  std::int64_t to = size;
  if (!call.integer(1, from) || (call.has(2) && !call.integer(2, to)))
    return false;
  // Negative positions count from the end; all others are moved inside.
  from = std::clamp<std::int64_t>(from < 0 ? from + size : from, 0, size);
  to = std::clamp<std::int64_t>(to < 0 ? to + size : to, from, size);
  // Finding a code point means counting from the start.
  if (!call.bytes(digits_of(box)))
    return false;
  if (box.is_list()) {
    if (!call.values(static_cast<std::size_t>(to - from)))
      return false;
    auto part = make_list(call.heap());
    const auto begin = box.list()->elements.begin();
    part.list()->elements.assign(begin + from, begin + to);
    return call.give(std::move(part));
  }
  const auto first =
      byte_position(*box.string(), static_cast<std::size_t>(from));
  const auto last = byte_position(*box.string(), static_cast<std::size_t>(to));
  return call.give(
      make_string(call.heap(), box.text().substr(first, last - first)));
}

// The element at a position that always exists, or unknown for an empty list.
namespace {

bool at_end(BuiltinCall& call, std::int64_t position) {
  if (!call[0].is_list() && !call[0].is_string() && !call[0].is_unknown() &&
      !call[0].is(ObjectType::result))
    return call.wrong_type(0, "a list");
  Box element;
  return call.machine.get_index(call[0], Box::small(position), element) &&
         call.give(std::move(element));
}

} // namespace

bool first(BuiltinCall& call) {
  return at_end(call, 0);
}

bool last(BuiltinCall& call) {
  return at_end(call, -1);
}

// Counts exactly as <for> does, as it uses the same machine functions; see
// Machine::for_prepare for the registers.
bool range(BuiltinCall& call) {
  Numeric bound;
  for (std::size_t i = 0; i < call.count; ++i)
    if (!call.number(i, bound))
      return false;
  Box loop[5];
  loop[1] = call[0];
  loop[2] = call.has(2) ? call[2] : Box::small(1);
  loop[3] = call[1];
  bool enters = false;
  auto list = make_list(call.heap());
  if (!call.machine.for_prepare(loop, enters))
    return false;
  if (!enters)
    return call.give(std::move(list));
  // The size is known before anything is made, so it is charged and checked
  // first.
  const auto count = static_cast<std::size_t>(loop[0].as_small()) + 1;
  if (!call.room(count * sizeof(Box)) || !call.values(count))
    return false;
  auto& elements = list.list()->elements;
  elements.push_back(loop[4]);
  while (loop[0].as_small() > 0) {
    if (!call.machine.for_next(loop))
      return false;
    elements.push_back(loop[4]);
  }
  return call.give(std::move(list));
}

// The keys and the values of a map, in insertion order.
bool keys(BuiltinCall& call) {
  if (!call[0].is_map())
    return call.wrong_type(0, "a map");
  return call.values(call[0].map()->entries.size()) &&
         call.give(keys_of(call.heap(), *call[0].map()));
}

bool values(BuiltinCall& call) {
  if (!call[0].is_map())
    return call.wrong_type(0, "a map");
  if (!call.values(call[0].map()->entries.size()))
    return false;
  auto list = make_list(call.heap());
  for (const auto& entry : call[0].map()->entries)
    list.list()->elements.push_back(entry.value);
  return call.give(std::move(list));
}

// Unknown has no keys (language rule 8.11).
bool has(BuiltinCall& call) {
  std::string key;
  if (call[0].is_unknown())
    return call.give_flag(false);
  if (!call[0].is_map())
    return call.wrong_type(0, "a map");
  return call.text(1, key) && call.give_flag(call[0].map()->find(key));
}

// One column of a result set as a list.
bool column(BuiltinCall& call) {
  std::string name;
  if (!call.text(1, name))
    return false;
  auto list = make_list(call.heap());
  if (call[0].is_unknown())
    return call.give(std::move(list));
  if (!call[0].is(ObjectType::result))
    return call.wrong_type(0, "a result");
  const auto& table = *call[0].result()->value.if_result();
  if (!call.values(table.cells.size())) // each row is searched for the column
    return false;
  for (std::size_t row = 0; row < table.row_count(); ++row) {
    const auto* cell = table.cell(row, name);
    if (!cell)
      return call.fail(ErrorKind::range,
                       "the result has no column '" + name + "'");
    list.list()->elements.push_back(call.machine.taken_in(*cell));
  }
  return call.give(std::move(list));
}

} // namespace parlour::script::builtins
