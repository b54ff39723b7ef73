// Built-in functions of lists, maps and results (language rules 8.4 to 8.6).
#include <algorithm>
#include <bit>

#include "script/values/convert.hpp"
#include "script/vm/builtin_call.hpp"
#include "script/vm/builtin_functions.hpp"

namespace parlour::script::builtins {

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

bool contains(BuiltinCall& call) {
  auto budget = call.machine.walk_budget();
  const auto before = budget;
  bool found = false;
  if (!call[0].is_unknown() && !call[0].is_object())
    return call.wrong_type(0, "a string, list or map");
  auto outcome = is_in(call[1], call[0], found, budget);
  if (outcome)
    return call.wrong_type(0, "a string, list or map");
  if (budget == 0)
    return call.fail(ErrorKind::limit, "too much to compare");
  if (call[0].is_string() && !call.work(call[0].string()->size))
    return false;
  return call.machine.charge(before - budget) && call.give_flag(found);
}

bool append(BuiltinCall& call) {
  if (!call[0].is_list())
    return call.wrong_type(0, "a list");
  std::size_t work = 0;
  return call.machine.check(script::append(call[0], call[1], work)) &&
         call.looked_at(work) && call.give(call[0]);
}

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
  std::size_t work = 0;
  if (!call.machine.check(refuse_ring(call[0], call[2], work)) ||
      !call.looked_at(work))
    return false;
  list->elements.insert(list->elements.begin() + at, call[2]);
  return call.give(call[0]);
}

bool remove(BuiltinCall& call) {
  Box removed;
  if (call[0].is_map()) {
    std::string key;
    return call.text(1, key) && call.work(call[0].map()->entries.size() * 4) &&
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
  removed = list->elements[*at];
  list->elements.erase(list->elements.begin() +
                       static_cast<std::ptrdiff_t>(*at));
  return call.give(std::move(removed));
}

namespace {

// Most lists that are sorted are of integers alone, and equal ones are the
// same.
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

// Each text is compared about as often as the list can be halved.
bool charge_texts(BuiltinCall& call, const Boxes& elements) {
  std::size_t bytes = 0;
  for (const auto& element : elements)
    bytes += element.string()->size;
  return call.work(bytes / 8 * std::bit_width(elements.size()));
}

} // namespace

// Numbers with numbers, or strings with strings.
bool sort(BuiltinCall& call) {
  ListObject* list = nullptr;
  std::string direction;
  if (!call.list(0, list) || (call.has(1) && !call.text(1, direction)))
    return false;
  auto& elements = list->elements;
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
  if (!call.machine.charge(elements.size() * 2) ||
      (!numbers && !charge_texts(call, elements)))
    return false;
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

bool reverse(BuiltinCall& call) {
  ListObject* list = nullptr;
  if (!call.list(0, list))
    return false;
  std::reverse(list->elements.begin(), list->elements.end());
  return call.give(call[0]);
}

bool index_of(BuiltinCall& call) {
  ListObject* list = nullptr;
  if (call[0].is_unknown())
    return call.give_integer(-1);
  if (!call.list(0, list))
    return false;
  auto budget = call.machine.walk_budget();
  const auto before = budget;
  const auto& elements = list->elements;
  const auto found =
      std::find_if(elements.begin(), elements.end(), [&](const Box& element) {
        return budget > 0 && equal(element, call[1], budget);
      });
  if (budget == 0)
    return call.fail(ErrorKind::limit, "too much to compare");
  return call.looked_at(before - budget) &&
         call.give_integer(found == elements.end() ? -1
                                                   : found - elements.begin());
}

// A list or a string, from included, to excluded.
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
  from = std::clamp<std::int64_t>(from < 0 ? from + size : from, 0, size);
  to = std::clamp<std::int64_t>(to < 0 ? to + size : to, from, size);
  if (!call.work(static_cast<std::size_t>(to - from) * 16))
    return false;
  if (box.is_list()) {
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

namespace {

bool at_end(BuiltinCall& call, std::int64_t position) {
  if (!call[0].is_list() && !call[0].is_string() && !call[0].is_unknown() &&
      !call[0].is(ObjectType::result))
    return call.wrong_type(0, "a list");
  Box element;
  return call.machine.check(
             get_index(call.heap(), call[0], Box::small(position), element)) &&
         call.give(std::move(element));
}

} // namespace

bool first(BuiltinCall& call) {
  return at_end(call, 0);
}

bool last(BuiltinCall& call) {
  return at_end(call, -1);
}

// Counts as <for> does.
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
  const auto count = static_cast<std::size_t>(loop[0].as_small()) + 1;
  if (!call.room(count * sizeof(Box)) || !call.machine.charge(count))
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

bool keys(BuiltinCall& call) {
  if (!call[0].is_map())
    return call.wrong_type(0, "a map");
  return call.work(call[0].map()->entries.size() * 16) &&
         call.give(keys_of(call.heap(), *call[0].map()));
}

bool values(BuiltinCall& call) {
  if (!call[0].is_map())
    return call.wrong_type(0, "a map");
  auto list = make_list(call.heap());
  for (const auto& entry : call[0].map()->entries)
    list.list()->elements.push_back(entry.value);
  return call.work(list.list()->elements.size() * 16) &&
         call.give(std::move(list));
}

bool has(BuiltinCall& call) {
  std::string key;
  if (call[0].is_unknown())
    return call.give_flag(false);
  if (!call[0].is_map())
    return call.wrong_type(0, "a map");
  return call.text(1, key) && call.give_flag(call[0].map()->find(key));
}

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
  if (!call.work(table.row_count() * 16))
    return false;
  for (std::size_t row = 0; row < table.row_count(); ++row) {
    const auto* cell = table.cell(row, name);
    if (!cell)
      return call.fail(ErrorKind::range,
                       "the result has no column '" + name + "'");
    list.list()->elements.push_back(to_box(call.heap(), *cell));
  }
  return call.give(std::move(list));
}

} // namespace parlour::script::builtins
