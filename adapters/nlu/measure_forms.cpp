// Numbers, durations and levels.
#include <cmath>

#include "adapters/nlu/form_reader.hpp"
#include "adapters/nlu/normal_forms.hpp"

namespace parlour::adapters::nlu {

namespace {

// "2.5" as a token, or nothing.
std::optional<double> decimal(std::string_view word) {
  const auto point = word.find('.');
  if (point == std::string_view::npos || point == 0)
    return {};
  const auto whole = digits_of(word.substr(0, point));
  const auto part = digits_of(word.substr(point + 1));
  if (!whole || !part)
    return {};
  const auto digits = static_cast<double>(word.size() - point - 1);
  return static_cast<double>(*whole) +
         static_cast<double>(*part) / std::pow(10, digits);
}

// Seconds of "minute", "hours" …; 0 for none.
std::int64_t unit_seconds(std::string_view word) {
  if (word.ends_with('s') && word.size() > 1)
    word.remove_suffix(1);
  if (word == "second" || word == "sec")
    return 1;
  if (word == "minute" || word == "min")
    return 60;
  if (word == "hour" || word == "hr")
    return 3600;
  if (word == "day")
    return 86'400;
  return word == "week" ? 604'800 : 0;
}

// "half an hour", "a quarter of an hour": the part of the unit that follows.
double part_of(FormReader& reader) {
  const auto start = reader.position();
  reader.skip("a");
  const double part = reader.skip("half")      ? 0.5
                      : reader.skip("quarter") ? 0.25
                                               : 0;
  if (part > 0) {
    reader.skip("of");
    reader.skip_any({"an", "a"});
    if (unit_seconds(reader.word()) > 0)
      return part;
  }
  reader.go_back(start);
  return 0;
}

// "two", "an", "one and a half", "2.5"; negative for none.
double amount(FormReader& reader) {
  if (const auto part = part_of(reader); part > 0)
    return part;
  if (reader.skip_any({"a", "an"}))
    return 1;
  if (const auto found = decimal(reader.word())) {
    reader.advance();
    return *found;
  }
  const auto number = reader.number();
  if (!number || number->ordinal)
    return -1;
  const auto half = reader.skip_all({"and", "a", "half"}) ? 0.5 : 0.0;
  return static_cast<double>(number->value) + half;
}

// One amount with its unit, in seconds; negative for none.
double measure(FormReader& reader) {
  const auto start = reader.position();
  const auto count = amount(reader);
  const auto unit = unit_seconds(reader.word());
  if (count < 0 || unit == 0 || count > 1e6) {
    reader.go_back(start);
    return -1;
  }
  reader.advance();
  const auto half = reader.skip_all({"and", "a", "half"}) ? 0.5 : 0.0;
  return (count + half) * static_cast<double>(unit);
}

// "-2" for "B2", "3" for "L3"; 0 for none.
std::int64_t short_level(std::string_view word) {
  if (word.size() < 2)
    return 0;
  const auto number = digits_of(word.substr(1));
  if (!number || *number > 200)
    return 0;
  return word[0] == 'b' ? -*number : word[0] == 'l' ? *number : 0;
}

bool skip_floor(FormReader& reader) {
  return reader.skip_any(
      {"floor", "level", "storey", "story", "floors", "flr"});
}

std::optional<FormAt> basement(FormReader reader) {
  const bool counted = reader.skip_any({"first", "1st"});
  const bool second = !counted && reader.skip_any({"second", "2nd"});
  const bool third = !counted && !second && reader.skip_any({"third", "3rd"});
  if (!reader.skip("basement"))
    return {};
  if (counted || second || third)
    return reader.form(second ? -2 : third ? -3 : -1);
  const auto start = reader.position();
  reader.skip_any({"level", "floor", "number"});
  if (const auto number = reader.number();
      number && number->value > 0 && number->value < 100)
    return reader.form(-number->value);
  reader.go_back(start);
  return reader.form(-1);
}

// "level 3", "floor twenty three", "level b1".
std::optional<FormAt> level_then_number(FormReader reader) {
  if (!skip_floor(reader))
    return {};
  reader.skip("number");
  if (const auto level = short_level(reader.word())) {
    reader.advance();
    return reader.form(level);
  }
  if (auto below = basement(reader)) {
    reader.advance(below->length - reader.length());
    return reader.form(below->value);
  }
  const auto number = reader.number();
  if (!number || number->value < 1 || number->value > 200)
    return {};
  return reader.form(number->value);
}

// "twenty third floor", "23rd level", "ground floor".
std::optional<FormAt> number_then_level(FormReader reader) {
  if (reader.skip_any({"ground", "street", "main"}))
    return skip_floor(reader) ? std::optional(reader.form(1)) : std::nullopt;
  const auto number = reader.number();
  if (!number || number->value < 1 || number->value > 200)
    return {};
  const bool whole = skip_floor(reader);
  return reader.form(number->value, !whole);
}

} // namespace

std::optional<FormAt> number_form(FormReader reader, Now) {
  if (const auto found = decimal(reader.word())) {
    reader.advance();
    return reader.form(*found, true);
  }
  const auto number = reader.number();
  if (!number || number->ordinal)
    return {};
  const auto start = reader.position();
  if (reader.skip("point")) {
    double value = 0, scale = 0.1;
    while (const auto digit = digit_of(reader.word())) {
      value += *digit * scale;
      scale /= 10;
      reader.advance();
    }
    if (value > 0)
      return reader.form(static_cast<double>(number->value) + value, true);
    reader.go_back(start);
  }
  return reader.form(number->value, true);
}

std::optional<FormAt> duration_form(FormReader reader, Now) {
  auto total = measure(reader);
  if (total < 0)
    return {};
  while (true) {
    const auto start = reader.position();
    reader.skip("and");
    const auto more = measure(reader);
    if (more < 0) {
      reader.go_back(start);
      return reader.form(static_cast<std::int64_t>(std::llround(total)));
    }
    total += more;
  }
}

std::optional<FormAt> level_form(FormReader reader, Now) {
  if (const auto level = short_level(reader.word())) {
    reader.advance();
    skip_floor(reader);
    return reader.form(level);
  }
  if (auto found = basement(reader))
    return found;
  if (auto found = level_then_number(reader))
    return found;
  return number_then_level(reader);
}

} // namespace parlour::adapters::nlu
