// Reads absolute dates: "21 november", "the 3rd of may 2027", "monday the
// 23rd", "2026-11-21", "christmas eve". Relative dates are in
// relative_date.cpp.
#include <algorithm>

#include "adapters/nlu/forms/calendar.hpp"
#include "adapters/nlu/forms/normal_forms.hpp"

namespace parlour::adapters::nlu {

namespace {

bool is_year(std::int64_t number) {
  return number >= 1900 && number <= 2200;
}

// Reads the second half of a year said in two parts: "oh five", "twenty eight".
std::optional<std::int64_t> end_of_year(FormReader& reader) {
  if (reader.skip_any({"oh", "o"})) {
    const auto digit = digit_of(reader.word());
    reader.advance(digit ? 1 : 0);
    return digit ? std::optional<std::int64_t>(*digit) : std::nullopt;
  }
  const auto number = reader.number();
  if (!number || number->ordinal || number->digits || number->value < 10 ||
      number->value > 99)
    return {};
  return number->value;
}

// Reads "2028", "two thousand and twenty eight" or "twenty twenty eight".
std::optional<std::int64_t> read_year(FormReader& reader) {
  const auto start = reader.position();
  const auto first = reader.number();
  if (first && !first->ordinal && is_year(first->value))
    return first->value;
  if (first && !first->digits && (first->value == 19 || first->value == 20))
    if (const auto second = end_of_year(reader))
      return first->value * 100 + *second;
  reader.go_back(start);
  return {};
}

// Completes a date with the year that follows, or with the year in which the
// day is next.
std::optional<FormAt> with_year(FormReader& reader, std::int64_t day,
                                std::int64_t month, Now now) {
  if (const auto year = read_year(reader)) {
    const auto date = make_day(*year, month, day);
    return date ? std::optional(reader.form(date_text(*date))) : std::nullopt;
  }
  const auto today = day_of(now);
  if (!today)
    return {};
  const auto this_year = int(std::chrono::year_month_day(*today).year());
  auto date = make_day(this_year, month, day);
  if (date && *date < *today)
    date = make_day(this_year + 1, month, day);
  return date ? std::optional(reader.form(date_text(*date))) : std::nullopt;
}

// "21 november", "the 3rd of may".
std::optional<FormAt> day_and_month(FormReader reader, Now now) {
  reader.skip("the");
  const auto day = reader.number();
  if (!day)
    return {};
  reader.skip("of");
  const auto month = month_of(reader.word());
  if (month == 0)
    return {};
  reader.advance();
  return with_year(reader, day->value, month, now);
}

// "november 21", "may the third".
std::optional<FormAt> month_and_day(FormReader reader, Now now) {
  const auto month = month_of(reader.word());
  if (month == 0)
    return {};
  reader.advance();
  reader.skip("the");
  const auto day = reader.number();
  return day ? with_year(reader, day->value, month, now) : std::nullopt;
}

// "2026-11-21", "21/11/2026", "21/11".
std::optional<FormAt> digital_date(FormReader reader, Now now) {
  const auto word = reader.word();
  reader.advance();
  for (const char separator : {'-', '/', '.'}) {
    if (const auto date = read_day(word, separator, now))
      return reader.form(date_text(*date));
  }
  // Day and month without a year.
  const auto slash = word.find('/');
  if (slash == std::string_view::npos)
    return {};
  const auto day = digits_of(word.substr(0, slash));
  const auto month = digits_of(word.substr(slash + 1));
  return day && month ? with_year(reader, *day, *month, now) : std::nullopt;
}

struct Feast {
  // Unused words are empty.
  std::string_view words[3];
  std::int64_t month, day;
};

// Longer names come before their beginnings: the first match counts.
constexpr Feast feasts[] = {
    {{"new", "year", "day"}, 1, 1},     {{"new", "years", "day"}, 1, 1},
    {{"new", "year", "eve"}, 12, 31},   {{"new", "years", "eve"}, 12, 31},
    {{"christmas", "eve", ""}, 12, 24}, {{"christmas", "day", ""}, 12, 25},
    {{"boxing", "day", ""}, 12, 26},    {{"valentine", "day", ""}, 2, 14},
    {{"valentines", "day", ""}, 2, 14}, {{"christmas", "", ""}, 12, 25},
};

std::optional<FormAt> feast(FormReader reader, Now now) {
  for (const auto& one : feasts) {
    const auto length =
        static_cast<std::size_t>(std::ranges::find(one.words, "") - one.words);
    bool same = true;
    for (std::size_t at = 0; at < length; ++at)
      same = same && reader.word(at) == one.words[at];
    if (!same)
      continue;
    reader.advance(length);
    return with_year(reader, one.day, one.month, now);
  }
  return {};
}

// Reads "monday the 23rd" or "monday, 23 november". The date counts, even if
// the weekday does not fit.
std::optional<FormAt> weekday_and_date(FormReader reader, Now now) {
  if (!weekday_of(reader.word()))
    return {};
  reader.advance();
  if (auto found = day_and_month(reader, now))
    return found;
  if (auto found = month_and_day(reader, now))
    return found;
  const auto today = day_of(now);
  auto found = today ? day_of_month(reader, *today) : std::nullopt;
  if (found)
    found->weak = false;
  return found;
}

} // namespace

std::optional<FormAt> date_form(FormReader reader, Now now) {
  // The order matters: the first reader that succeeds is taken.
  for (const auto read :
       {digital_date, day_and_month, month_and_day, feast, weekday_and_date})
    if (auto found = read(reader, now))
      return found;
  const auto today = day_of(now);
  return today ? date_from_now(reader, *today) : std::nullopt;
}

} // namespace parlour::adapters::nlu
