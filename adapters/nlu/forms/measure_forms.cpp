// Reads numbers, durations and levels of a building.
#include <cmath>
#include <string>

#include "adapters/nlu/forms/form_reader.hpp"
#include "adapters/nlu/forms/normal_forms.hpp"

namespace parlour::adapters::nlu {

namespace {

// A token such as "2.5".
std::optional<double> decimal(std::string_view word) {
  const auto point = word.find('.');
  const bool is_one = point != std::string_view::npos &&
                      digits_of(word.substr(0, point)) &&
                      digits_of(word.substr(point + 1));
  return is_one ? std::optional(parse_number(word).number_or(0)) : std::nullopt;
}

// The seconds of "minute", "hours" …; 0 if the word is no unit.
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
  if (word == "week")
    return 604'800;
  return word == "fortnight" ? 1'209'600 : 0;
}

// Reads "and a half", "and a quarter" or "and three quarters"; 0 if none
// follows.
double fraction_behind(FormReader& reader) {
  if (reader.skip_all({"and", "a", "half"}))
    return 0.5;
  if (reader.skip_all({"and", "a", "quarter"}))
    return 0.25;
  return reader.skip_all({"and", "three", "quarters"}) ? 0.75 : 0;
}

// Reads "point oh five" and returns the digits behind the point. Empty if there
// are none, or only zeros.
std::string decimals(FormReader& reader) {
  const auto start = reader.position();
  std::string digits;
  if (reader.skip("point"))
    while (const auto digit = digit_of(reader.word())) {
      digits += static_cast<char>('0' + *digit);
      reader.advance();
    }
  if (digits.find_first_not_of('0') == std::string::npos) {
    reader.go_back(start);
    return {};
  }
  return digits;
}

// Parses the number as text. Adding up decimal places would lose precision.
double with_decimals(std::int64_t whole, const std::string& digits) {
  return parse_number(std::to_string(whole) + "." + digits).number_or(0);
}

// The seconds of "2h", "90m", "30s" or "1h30"; negative if the word is none of
// these.
std::int64_t compact_seconds(std::string_view word) {
  const auto end = word.find_first_not_of("0123456789");
  const auto count = digits_of(word.substr(0, end));
  if (!count || end == std::string_view::npos || *count > 10'000)
    return -1;
  const auto rest = word.substr(end + 1);
  const auto minutes = digits_of(rest);
  if (word[end] == 'h' && (rest.empty() || (minutes && *minutes < 60)))
    return *count * 3600 + minutes.value_or(0) * 60;
  if (!rest.empty())
    return -1;
  return word[end] == 'm' ? *count * 60 : word[end] == 's' ? *count : -1;
}

// Reads "half an hour" or "a quarter of an hour" up to the unit, which must
// follow. Returns the part of the unit, or 0.
double part_of(FormReader& reader) {
  const auto start = reader.position();
  const bool three = reader.skip("three");
  if (!three)
    reader.skip("a");
  const double part = three ? (reader.skip("quarters") ? 0.75 : 0)
                      : reader.skip("half")    ? 0.5
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

// Reads "two", "an", "one and a half" or "2.5"; negative if no amount follows.
double amount(FormReader& reader) {
  if (const auto part = part_of(reader); part > 0)
    return part;
  const auto start = reader.position();
  if (reader.skip_any({"a", "an"})) {
    if (unit_seconds(reader.word()) > 0)
      return 1;
    reader.go_back(start);
  }
  if (const auto found = decimal(reader.word())) {
    reader.advance();
    return *found;
  }
  const auto number = reader.count();
  if (!number || number->ordinal)
    return -1;
  if (const auto digits = decimals(reader); !digits.empty())
    return with_decimals(number->value, digits);
  return static_cast<double>(number->value) + fraction_behind(reader);
}

// Reads the minutes in "two hours thirty", in seconds. A unit behind them means
// that they are an amount of their own.
double minutes_behind(FormReader& reader, std::int64_t unit) {
  const auto start = reader.position();
  const auto number = reader.number();
  if (unit == 3600 && number && !number->ordinal && number->value >= 10 &&
      number->value < 60 && unit_seconds(reader.word()) == 0)
    return static_cast<double>(number->value) * 60;
  reader.go_back(start);
  return 0;
}

// Reads one amount with its unit, in seconds; negative if there is none.
double measure(FormReader& reader) {
  if (const auto seconds = compact_seconds(reader.word()); seconds >= 0) {
    reader.advance();
    return static_cast<double>(seconds);
  }
  const auto start = reader.position();
  const auto count = amount(reader);
  const auto unit = unit_seconds(reader.word());
  // An amount without a unit is no measure.
  if (count < 0 || unit == 0 || count > 1e6) {
    reader.go_back(start);
    return -1;
  }
  reader.advance();
  const auto seconds =
      (count + fraction_behind(reader)) * static_cast<double>(unit);
  return seconds + minutes_behind(reader, unit);
}

// -2 for "B2", 3 for "L3" and "3F"; 0 if the word is no level.
std::int64_t short_level(std::string_view word) {
  if (word.size() < 2)
    return 0;
  if (word.back() == 'f' && word[0] != 'b' && word[0] != 'l') {
    const auto number = digits_of(word.substr(0, word.size() - 1));
    return number && *number <= 200 ? *number : 0;
  }
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

// Reads "level 3", "floor twenty three" or "level b1".
std::optional<FormAt> level_then_number(FormReader reader) {
  if (!skip_floor(reader))
    return {};
  reader.skip("number");
  if (const auto level = short_level(reader.word())) {
    reader.advance();
    return reader.form(level);
  }
  if (reader.skip("minus")) {
    const auto below = reader.number();
    return below && below->value > 0 && below->value < 100
               ? std::optional(reader.form(-below->value))
               : std::nullopt;
  }
  // basement() read on with a copy: the reader is moved to where the copy
  // ended.
  if (auto below = basement(reader)) {
    reader.advance(below->length - reader.length());
    return reader.form(below->value);
  }
  const auto number = reader.number();
  if (!number || number->value < 1 || number->value > 200)
    return {};
  return reader.form(number->value);
}

// Reads "twenty third floor", "ground floor" or "minus one". Ground floor is 1,
// and there is no level 0. A number alone is weak.
std::optional<FormAt> number_then_level(FormReader reader) {
  if (reader.skip_all({"lower", "ground"}))
    return skip_floor(reader) ? std::optional(reader.form(-1)) : std::nullopt;
  if (reader.skip_any({"ground", "street", "main"}))
    return skip_floor(reader) ? std::optional(reader.form(1)) : std::nullopt;
  const bool below = reader.skip("minus");
  const auto number = reader.number();
  if (!number || number->value < 1 || number->value > 200)
    return {};
  const bool whole = skip_floor(reader);
  return reader.form(below ? -number->value : number->value, !whole);
}

// Reads digits with an "oh" among them as a number: "double oh seven". Negative
// if there is none.
std::int64_t digit_row(FormReader& reader) {
  const auto start = reader.position();
  std::int64_t value = 0;
  std::size_t digits = 0;
  bool with_oh = false;
  while (digits < 12) {
    const int times = reader.skip("double") ? 2 : 1;
    const auto word = reader.word();
    const auto digit = digit_of(word);
    if (!digit)
      break;
    with_oh = with_oh || word == "oh" || word == "o";
    // "double seven" gives two digits.
    for (int time = 0; time < times; ++time, ++digits)
      value = value * 10 + *digit;
    reader.advance();
  }
  // Without an "oh" the words may be an ordinary number ("three five").
  if (digits >= 3 && with_oh)
    return value;
  reader.go_back(start);
  return -1;
}

// Reads a number without a sign.
std::optional<Value> plain_number(FormReader& reader) {
  if (const auto found = decimal(reader.word())) {
    reader.advance();
    return Value(*found);
  }
  if (const auto row = digit_row(reader); row >= 0)
    return Value(row);
  // "three point five".
  if (const auto digits = decimals(reader); !digits.empty())
    return Value(with_decimals(0, digits));
  const auto number = reader.count();
  if (!number || number->ordinal)
    return {};
  if (const auto digits = decimals(reader); !digits.empty())
    return Value(with_decimals(number->value, digits));
  if (const auto part = fraction_behind(reader); part > 0)
    return Value(static_cast<double>(number->value) + part);
  return Value(number->value);
}

} // namespace

// Numbers are weak: in most sentences a number is part of something else.
std::optional<FormAt> number_form(FormReader reader, Now) {
  if (const auto spelled = spelled_number(reader))
    return reader.form(*spelled, true);
  const bool negative = reader.skip_any({"minus", "negative"});
  const auto number = plain_number(reader);
  if (!number)
    return {};
  if (!negative)
    return reader.form(*number, true);
  if (const auto* whole = number->if_integer())
    return reader.form(-*whole, true);
  return reader.form(-number->number_or(0), true);
}

// Adds up measures: "one hour and ten minutes".
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
