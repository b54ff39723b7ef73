// Built-in functions of strings (language rule 8.2).
#include <algorithm>

#include "script/spoken/letter_case.hpp"
#include "script/vm/builtin_call.hpp"
#include "script/vm/builtin_functions.hpp"

namespace parlour::script::builtins {

namespace {

constexpr std::string_view blanks = " \t\r\n";

using Mapping = std::optional<std::string> (*)(std::string_view);

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

// A position in a string, counted from the end where it is negative, never
// outside of it.
std::size_t clamped(std::int64_t position, std::size_t size) {
  const auto signed_size = static_cast<std::int64_t>(size);
  if (position < 0)
    position += signed_size;
  return static_cast<std::size_t>(
      std::clamp<std::int64_t>(position, 0, signed_size));
}

Box part_of(BuiltinCall& call, const StringObject& string, std::size_t from,
            std::size_t to) {
  const auto first = byte_position(string, from);
  const auto last = byte_position(string, to);
  return make_string(call.heap(), string.text().substr(first, last - first),
                     static_cast<std::uint32_t>(to - from));
}

std::size_t occurrences(std::string_view text, std::string_view part) {
  std::size_t count = 0;
  for (auto at = find_text(text, part); at != std::string_view::npos;
       at = find_text(text, part, at + part.size()))
    ++count;
  return count;
}

// Fills a string that is as large as the result.
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

bool upper(BuiltinCall& call) {
  return map_case(call, capitals);
}

bool lower(BuiltinCall& call) {
  return map_case(call, small_letters);
}

bool trim(BuiltinCall& call) {
  std::string text;
  if (!call.text(0, text))
    return false;
  text.erase(text.find_last_not_of(blanks) + 1);
  text.erase(0, std::min(text.find_first_not_of(blanks), text.size()));
  return call.give_text(text);
}

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
  if (!call.room(size) || !call.work(size))
    return false;
  auto* replaced = raw_string(call.heap(), size);
  replace_all(text->text(), part->text(), with->text(), replaced->data());
  return call.give(finish_string(replaced));
}

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

bool split(BuiltinCall& call) {
  std::string text;
  std::string separator;
  if (!call.text(0, text) || (call.has(1) && !call.text(1, separator)) ||
      !call.work(text.size() * 16))
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

bool join(BuiltinCall& call) {
  ListObject* list = nullptr;
  std::string separator;
  if (!call.list(0, list) || (call.has(1) && !call.text(1, separator)))
    return false;
  std::string text;
  const auto limit = call.machine.program->settings.limits.result;
  for (const auto& element : list->elements) {
    if (&element != list->elements.data())
      text += separator;
    if (!print(text, element, limit))
      return call.room(limit + 1);
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

bool string(BuiltinCall& call) {
  std::string text;
  const auto limit = call.machine.program->settings.limits.result;
  if (!print(text, call[0], limit))
    return call.room(limit + 1);
  return call.give_text(text);
}

} // namespace parlour::script::builtins
