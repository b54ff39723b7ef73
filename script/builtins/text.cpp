// Built-in functions for strings (language rule 8.2). Positions count
// characters, strings are stored in UTF-8: ASCII strings, whose two lengths are
// equal, take the fast paths in script/values.
#include <algorithm>

#include "script/spoken/letter_case.hpp"
#include "script/vm/builtin_call.hpp"
#include "script/vm/builtin_functions.hpp"

namespace parlour::script::builtins {

namespace {

constexpr std::string_view blanks = " \t\r\n";

using Mapping = std::optional<std::string> (*)(std::string_view);

// No character grows to more than three times its bytes.
bool map_case(BuiltinCall& call, Mapping mapping) {
  std::string text;
  if (!call.text(0, text) || !call.room(text.size() * 3))
    return false;
  const auto mapped = mapping(text);
  return mapped ? call.give_text(*mapped)
                : call.fail(ErrorKind::type, "the text is not well-formed");
}

std::size_t code_points_before(std::string_view text, std::size_t byte) {
  return count_code_points(text.substr(0, byte));
}

// A position within a string; negative ones count from its end, and positions
// outside move to the nearest end.
std::size_t clamped(std::int64_t position, std::size_t size) {
  const auto signed_size = static_cast<std::int64_t>(size);
  if (position < 0)
    position += signed_size;
  return static_cast<std::size_t>(
      std::clamp<std::int64_t>(position, 0, signed_size));
}

// The characters [from, to) of a string.
Box part_of(BuiltinCall& call, const StringObject& string, std::size_t from,
            std::size_t to) {
  const auto first = byte_position(string, from);
  const auto last = byte_position(string, to);
  return make_string(call.heap(), string.text().substr(first, last - first),
                     static_cast<std::uint32_t>(to - from));
}

// Occurrences do not overlap.
std::size_t occurrences(std::string_view text, std::string_view part) {
  std::size_t count = 0;
  for (auto at = find_text(text, part); at != std::string_view::npos;
       at = find_text(text, part, at + part.size()))
    ++count;
  return count;
}

// Writes the result into `target`, which has exactly the size of the result.
void replace_all(std::string_view text, std::string_view part,
                 std::string_view with, char* target) {
  std::size_t at = 0;
  for (auto found = find_text(text, part); found != std::string_view::npos;
       found = find_text(text, part, at)) {
    target = std::copy(text.begin() + at, text.begin() + found, target);
    target = std::copy(with.begin(), with.end(), target);
    at = found + part.size();
  }
  std::copy(text.begin() + at, text.end(), target);
}

} // namespace

// By Unicode, so the length can change: 'ß' becomes 'SS'.
bool upper(BuiltinCall& call) {
  return map_case(call, capitals);
}

bool lower(BuiltinCall& call) {
  return map_case(call, small_letters);
}

// Removes blanks, tabs and line ends at both ends.
bool trim(BuiltinCall& call) {
  std::string text;
  if (!call.text(0, text))
    return false;
  text.erase(text.find_last_not_of(blanks) + 1);
  text.erase(0, std::min(text.find_first_not_of(blanks), text.size()));
  return call.give_text(text);
}

// A start or count beyond the end is no error: the result is shorter.
bool substring(BuiltinCall& call) {
  const auto* string = call.string(0);
  std::int64_t start = 0;
  if (!string || !call.integer(1, start))
    return false;
  const auto size = string->code_points;
  std::int64_t count = size;
  if (call.has(2) && !call.integer(2, count))
    return false;
  const auto from = clamped(start, size);
  const auto rest = static_cast<std::int64_t>(size - from);
  const auto length =
      static_cast<std::size_t>(std::clamp<std::int64_t>(count, 0, rest));
  return call.give(part_of(call, *string, from, from + length));
}

// Searches in bytes and returns a position in characters; -1 if absent.
bool find(BuiltinCall& call) {
  const auto* string = call.string(0);
  const auto* part = string ? call.string(1) : nullptr;
  std::int64_t from = 0;
  if (!part || (call.has(2) && !call.integer(2, from)))
    return false;
  const auto text = string->text();
  const auto start = byte_position(*string, clamped(from, string->code_points));
  const auto found = find_text(text, part->text(), start);
  return call.give_integer(
      found == std::string_view::npos
          ? -1
          : static_cast<std::int64_t>(code_points_before(text, found)));
}

// The occurrences are counted first, so that the result is allocated once.
bool replace(BuiltinCall& call) {
  const auto* text = call.string(0);
  const auto* part = text ? call.string(1) : nullptr;
  const auto* with = part ? call.string(2) : nullptr;
  if (!with)
    return false;
  const auto count =
      part->size == 0 ? 0 : occurrences(text->text(), part->text());
  if (count == 0)
    return call.give(call[0]);
  const auto size = text->size - count * part->size + count * with->size;
  if (!call.room(size) || !call.bytes(size))
    return false;
  auto* replaced = raw_string(call.heap(), size);
  replace_all(text->text(), part->text(), with->text(), replaced->data());
  return call.give(finish_string(replaced));
}

// Three ways to split: at runs of blanks, into characters, at a separator.
namespace {

void split_blanks(Heap& heap, std::string_view text, Boxes& parts) {
  for (std::size_t at = text.find_first_not_of(blanks);
       at != std::string_view::npos;) {
    const auto end = std::min(text.find_first_of(blanks, at), text.size());
    parts.push_back(make_string(heap, text.substr(at, end - at)));
    at = text.find_first_not_of(blanks, end);
  }
}

void split_code_points(Heap& heap, std::string_view text, Boxes& parts) {
  for (std::size_t at = 0; at < text.size();) {
    const auto size = character_size(text[at]);
    parts.push_back(make_string(heap, text.substr(at, size)));
    at += size;
  }
}

// A separator at an end gives an empty part there.
void split_at(Heap& heap, std::string_view text, std::string_view separator,
              Boxes& parts) {
  std::size_t at = 0;
  for (auto found = find_text(text, separator); found != std::string_view::npos;
       found = find_text(text, separator, at)) {
    parts.push_back(make_string(heap, text.substr(at, found - at)));
    at = found + separator.size();
  }
  parts.push_back(make_string(heap, text.substr(at)));
}

} // namespace

// Each byte can be a part, which costs an allocation: as much as four values.
bool split(BuiltinCall& call) {
  std::string text;
  std::string separator;
  if (!call.text(0, text) || (call.has(1) && !call.text(1, separator)) ||
      !call.values(text.size() * 4))
    return false;
  auto list = make_list(call.heap());
  auto& parts = list.list()->elements;
  if (!call.has(1))
    split_blanks(call.heap(), text, parts);
  else if (separator.empty())
    split_code_points(call.heap(), text, parts);
  else
    split_at(call.heap(), text, separator, parts);
  return call.give(std::move(list));
}

// Elements are printed, so any list can be joined. The limit is checked between
// elements, before the text grows further.
bool join(BuiltinCall& call) {
  ListObject* list = nullptr;
  std::string separator;
  if (!call.list(0, list) || (call.has(1) && !call.text(1, separator)))
    return false;
  std::string text;
  for (const auto& element : list->elements) {
    if (&element != list->elements.data())
      text += separator;
    if (!call.print(text, element))
      return false;
  }
  return call.give_text(text);
}

bool starts_with(BuiltinCall& call) {
  std::string text;
  std::string part;
  return call.text(0, text) && call.text(1, part) &&
         call.give_flag(text.starts_with(part));
}

bool ends_with(BuiltinCall& call) {
  std::string text;
  std::string part;
  return call.text(0, text) && call.text(1, part) &&
         call.give_flag(text.ends_with(part));
}

// The printed form (language rule 2.2).
bool string(BuiltinCall& call) {
  std::string text;
  return call.print(text, call[0]) && call.give_text(text);
}

} // namespace parlour::script::builtins
