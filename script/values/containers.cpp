// Access to elements and fields (language rules 2.8 to 2.11).
#include <algorithm>
#include <cstring>
#include <unordered_set>

#include "script/values/convert.hpp"
#include "script/values/operations.hpp"

namespace parlour::script {

namespace {

Failure type_failure(std::string message) {
  return {ErrorKind::type, std::move(message)};
}

// The integer that a key stands for, if any. Numbers without a fraction count:
// 2.0 is a position.
std::optional<std::int64_t> position_of(const Box& key) {
  if (key.is_small())
    return key.as_small();
  const auto number = numeric(key);
  if (!number)
    return {};
  if (number->is_integer)
    return number->integer;
  const auto value = number->number;
  if (value < -9e15 || value > 9e15 ||
      value != static_cast<double>(static_cast<std::int64_t>(value)))
    return {};
  return static_cast<std::int64_t>(value);
}

// Of what is printed to be a key. A text that is one may be as long as any.
constexpr std::size_t longest_printed_key = 1 << 20;

Failure too_long_as_key(const Box& value) {
  return {ErrorKind::limit,
          a_type(value) + " is too long or too deep to be a key, which is its "
                          "printed form"};
}

// The message shows what was given instead of an integer.
Failure position_failure(const Box& container, const Box& key) {
  return type_failure(
      "a position in " + a_type(container) + " must be an integer, not " +
      (key.is_string() ? "'" + std::string(key.text()) + "'" : a_type(key)));
}

Box character_at(Heap& heap, const StringObject& string, std::size_t position) {
  const auto rest = string.text().substr(byte_position(string, position));
  // The text may come from outside and be invalid, so its end may come earlier
  // than its first byte says.
  const auto size = rest.empty() ? 0 : character_size(rest.front());
  return make_string(heap, rest.substr(0, size));
}

// The fields of a caught error (language rule 9.1).
Outcome error_field(Heap& heap, const ErrorObject& error, std::string_view name,
                    Box& result) {
  if (name == "message")
    result = make_string(heap, error.message);
  else if (name == "kind")
    result = make_string(heap, name_of(error.kind));
  else if (name == "file")
    result = make_string(heap, error.place.file);
  else if (name == "line")
    result = Box::small(error.place.line);
  else if (name == "value")
    result = error.value;
  else
    return type_failure("an error has no field '" + std::string(name) +
                        "'; it has message, kind, file, line and value");
  return {};
}

// The fields of a query's result: count, columns and rows.
Outcome result_field(Heap& heap, const Box& box, std::string_view name,
                     Box& result) {
  const auto& value = box.result()->value;
  if (name == "count") {
    result =
        Box::small(static_cast<std::int64_t>(value.if_result()->row_count()));
  } else if (name == "columns") {
    result = make_list(heap);
    for (const auto& column : value.if_result()->columns)
      result.list()->elements.push_back(make_string(heap, column));
  } else if (name == "rows") {
    result = rows_of(heap, box);
  } else {
    return type_failure("a result set has no field '" + std::string(name) +
                        "'; it has count, columns and rows");
  }
  return {};
}

// The number of positions in a list, a string or a result.
std::size_t size_of(const Box& container) {
  if (container.is_list())
    return container.list()->elements.size();
  if (container.is_string())
    return container.string()->code_points;
  return container.result()->value.if_result()->cells.size();
}

// Of a result set the cells count one by one, row after row.
Box element_at(Heap& heap, const Box& container, std::size_t at) {
  if (container.is_list())
    return container.list()->elements[at];
  if (container.is_string())
    return character_at(heap, *container.string(), at);
  return to_box(heap, container.result()->value.if_result()->cells[at]);
}

bool contains_others(const Box& box) {
  return box.is_list() || box.is_map() || box.is(ObjectType::error) ||
         box.is(ObjectType::result);
}

// Searches for an object in everything that a value holds. It uses a stack of
// its own and visits each object once, so neither deep nor heavily shared
// structures are a problem.
class Search {
public:
  Search(const Object* wanted, WalkBudget& budget)
      : wanted_(wanted), budget_(budget) {}
  bool below(const Box& from) {
    visit(from);
    while (!found_ && !open_.empty() && !budget_.exhausted()) {
      const auto* object = open_.back();
      open_.pop_back();
      look_into(object);
    }
    return found_;
  }

private:
  void visit(const Box& box) {
    if (!budget_.values() || !contains_others(box) || found_)
      return;
    budget_.values(values_of_a_mark);
    found_ = box.object() == wanted_;
    if (seen_.insert(box.object()).second)
      open_.push_back(box.object());
  }
  void look_into(const Object* object) {
    if (object->type == ObjectType::list)
      for (const auto& element :
           static_cast<const ListObject*>(object)->elements)
        visit(element);
    else if (object->type == ObjectType::map)
      for (const auto& entry : static_cast<const MapObject*>(object)->entries)
        visit(entry.value);
    else if (object->type == ObjectType::error)
      visit(static_cast<const ErrorObject*>(object)->value);
    else
      visit(static_cast<const ResultObject*>(object)->rows);
  }

  // Remembering an object costs as much as visiting this many values.
  static constexpr std::size_t values_of_a_mark = 16;

  const Object* wanted_;
  WalkBudget& budget_;
  bool found_ = false;
  std::vector<const Object*> open_;
  std::unordered_set<const Object*> seen_;
};

// Setting the position behind the end appends (language rule 2.9).
Outcome set_element(const Box& list, const Box& key, Box value) {
  const auto position = position_of(key);
  if (!position)
    return position_failure(list, key);
  auto& elements = list.list()->elements;
  const auto size = elements.size();
  if (*position == static_cast<std::int64_t>(size)) {
    elements.push_back(std::move(value));
    return {};
  }
  const auto at = place_in(*position, size);
  if (!at)
    return Failure{ErrorKind::range, "position " + std::to_string(*position) +
                                         " is outside of a list of " +
                                         std::to_string(size)};
  elements[*at] = std::move(value);
  return {};
}

} // namespace

Box key_text(Heap& heap, const Box& key) {
  if (key.is_string())
    return key;
  std::string text;
  if (!print(text, key, longest_printed_key))
    return Box::missing();
  return make_string(heap, text);
}

// -1 is the last position (language rule 2.8).
std::optional<std::size_t> place_in(std::int64_t position, std::size_t size) {
  if (position < 0)
    position += static_cast<std::int64_t>(size);
  if (position < 0 || position >= static_cast<std::int64_t>(size))
    return {};
  return static_cast<std::size_t>(position);
}

// By the first byte of valid UTF-8; other bytes count as one character.
std::size_t character_size(char first) {
  const auto byte = static_cast<unsigned char>(first);
  return byte < 0x80 ? 1 : byte < 0xe0 ? 2 : byte < 0xf0 ? 3 : 4;
}

std::size_t find_text(std::string_view text, std::string_view part,
                      std::size_t from) {
  // For a short text the naive search is faster: memmem first builds a table.
  constexpr std::size_t short_text = 64;
  if (text.size() <= short_text)
    return text.find(part, from);
  if (from > text.size())
    return std::string_view::npos;
  const auto* found = static_cast<const char*>(
      memmem(text.data() + from, text.size() - from, part.data(), part.size()));
  return found ? static_cast<std::size_t>(found - text.data())
               : std::string_view::npos;
}

// In ASCII text, where both counts are equal, a position is an offset.
std::size_t byte_position(const StringObject& string, std::size_t code_point) {
  if (string.code_points == string.size)
    return std::min<std::size_t>(code_point, string.size);
  const auto text = string.text();
  std::size_t at = 0;
  while (code_point-- > 0 && at < text.size())
    at += character_size(text[at]);
  return std::min(at, text.size());
}

// The rows are converted when they are first asked for and kept with the
// result.
Box rows_of(Heap& heap, const Box& result) {
  auto& object = *result.result();
  if (!object.rows.is_unknown())
    return object.rows;
  const auto& table = *object.value.if_result();
  std::vector<Box> names;
  for (const auto& column : table.columns)
    names.push_back(make_string(heap, column));
  object.rows = make_list(heap, table.row_count());
  for (std::size_t row = 0; row < table.row_count(); ++row) {
    auto map = make_map(heap);
    for (std::size_t i = 0; i < names.size(); ++i)
      map.map()->set(names[i],
                     to_box(heap, table.cells[row * names.size() + i]));
    object.rows.list()->elements.push_back(std::move(map));
  }
  return object.rows;
}

// The key objects are shared, not copied.
Box keys_of(Heap& heap, const MapObject& map) {
  auto keys = make_list(heap, map.entries.size());
  for (const auto& entry : map.entries)
    keys.list()->elements.push_back(entry.key);
  return keys;
}

// Missing elements and unknown containers give unknown (language rule 2.8).
Outcome get_index(Heap& heap, const Box& container, const Box& key,
                  Box& result) {
  if (container.is_unknown()) {
    result = Box();
    return {};
  }
  if (container.is_map()) {
    const auto text = key_text(heap, key);
    if (text.is_missing())
      return too_long_as_key(key);
    const auto* value = container.map()->find(*text.string());
    result = value ? *value : Box();
    return {};
  }
  if (!container.is_list() && !container.is_string() &&
      !container.is(ObjectType::result))
    return type_failure(a_type(container) + " cannot be indexed");
  const auto position = position_of(key);
  if (!position)
    return position_failure(container, key);
  const auto at = place_in(*position, size_of(container));
  result = at ? element_at(heap, container, *at) : Box();
  return {};
}

// Maps first, as they are by far the most frequent.
Outcome get_field(Heap& heap, const Box& container, const Box& name,
                  Box& result) {
  if (container.is_map()) {
    const auto* value = container.map()->find(*name.string());
    result = value ? *value : Box();
    return {};
  }
  if (container.is_unknown()) {
    result = Box();
    return {};
  }
  if (container.is(ObjectType::result))
    return result_field(heap, container, name.text(), result);
  if (container.is(ObjectType::error))
    return error_field(heap, *container.error(), name.text(), result);
  return type_failure(a_type(container) + " has no field '" +
                      std::string(name.text()) + "'");
}

// A container in only one box is held by a variable alone, so no value can
// contain it and the search is not needed. This is the usual case of a list
// that is built in a loop.
Outcome refuse_ring(const Box& container, const Box& value,
                    WalkBudget& budget) {
  if (!contains_others(value) || container.object()->count == 1)
    return {};
  if (Search(container.object(), budget).below(value))
    return Failure{ErrorKind::range,
                   "a list or map cannot be put inside of itself"};
  if (budget.exhausted())
    return Failure{ErrorKind::limit, "too much to put into a list or map"};
  return {};
}

// Setting in something unknown is an error of kind Range (language rule 2.9).
Outcome set_index(Heap& heap, const Box& container, const Box& key, Box value,
                  WalkBudget& budget) {
  if (container.is_unknown()) {
    const auto text = key_text(heap, key);
    return text.is_missing()
               ? too_long_as_key(key)
               : Failure{ErrorKind::range, "there is no list or map to set '" +
                                               std::string(text.text()) +
                                               "' in: it is unknown"};
  }
  if (!container.is_list() && !container.is_map())
    return type_failure("nothing can be set inside of " + a_type(container));
  if (auto ring = refuse_ring(container, value, budget))
    return ring;
  if (container.is_list())
    return set_element(container, key, std::move(value));
  auto text = key_text(heap, key);
  if (text.is_missing())
    return too_long_as_key(key);
  container.map()->set(std::move(text), std::move(value));
  return {};
}

Outcome append(const Box& list, Box value, WalkBudget& budget) {
  if (!list.is_list())
    return type_failure("append needs a list, not " + a_type(list));
  if (auto ring = refuse_ring(list, value, budget))
    return ring;
  list.list()->elements.push_back(std::move(value));
  return {};
}

Outcome is_in(const Box& element, const Box& container, bool& result,
              WalkBudget& budget) {
  result = false;
  if (container.is_unknown())
    return {};
  // In maps `in` looks for a key and in strings for a part, both of the printed
  // form of the element (language rule 3.11).
  if (container.is_list()) {
    for (const auto& candidate : container.list()->elements)
      if ((result = equal(candidate, element, budget)) || budget.exhausted())
        break;
    return {};
  }
  std::string text;
  const bool is_whole = print(text, element, longest_printed_key);
  if (!budget.bytes(text.size() + digits_of(container)))
    return {};
  if (!is_whole)
    return too_long_as_key(element);
  if (container.is_map())
    result = container.map()->find(text) != nullptr;
  else if (container.is_string())
    result = find_text(container.text(), text) != std::string_view::npos;
  else
    return Failure{ErrorKind::type, "'in' needs a list, a map or a string on "
                                    "its right, not " +
                                        a_type(container)};
  return {};
}

} // namespace parlour::script
