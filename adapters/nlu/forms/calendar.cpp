#include "adapters/nlu/forms/calendar.hpp"

#include <cstdio>

namespace parlour::adapters::nlu {

namespace {

using std::chrono::year_month_day;

constexpr std::string_view months[] = {
    "january", "february", "march",     "april",   "may",      "june",
    "july",    "august",   "september", "october", "november", "december"};

constexpr std::string_view weekdays[] = {"sunday",    "monday",   "tuesday",
                                         "wednesday", "thursday", "friday",
                                         "saturday"};

// How far in the future a year of two digits may lie.
constexpr std::int64_t years_ahead = 20;

// The latest year up to 20 years ahead that ends in these two digits.
std::optional<std::int64_t> century_of(std::int64_t year, Now now) {
  const auto present =
      now ? digits_of(format_timestamp(*now, "%Y")) : std::nullopt;
  if (year > 99 || !present)
    return year > 99 ? std::optional(year) : std::nullopt;
  const auto last = *present + years_ahead;
  return last - (last - year) % 100;
}

} // namespace

std::string date_text(Day day) {
  const year_month_day date(day);
  // Three numbers of the widest types would fit.
  char text[32];
  std::snprintf(text, sizeof text, "%04d-%02u-%02u", int(date.year()),
                unsigned(date.month()), unsigned(date.day()));
  return text;
}

std::optional<Day> make_day(std::int64_t year, std::int64_t month,
                            std::int64_t day) {
  // A month of chrono has one byte.
  if (year < 1900 || year > 2200 || month < 1 || month > 12 || day < 1 ||
      day > 31)
    return {};
  const year_month_day date{std::chrono::year(static_cast<int>(year)),
                            std::chrono::month(static_cast<unsigned>(month)),
                            std::chrono::day(static_cast<unsigned>(day))};
  return date.ok() ? std::optional(Day(date)) : std::nullopt;
}

std::optional<Day> read_day(std::string_view text, char separator, Now now) {
  std::int64_t parts[3] = {0, 0, 0};
  // Three numbers between the separators, and nothing else.
  for (auto& part : parts) {
    const auto end = text.find(separator);
    const auto number = digits_of(text.substr(0, end));
    if (!number)
      return {};
    part = *number;
    text = end == std::string_view::npos ? "" : text.substr(end + 1);
  }
  if (!text.empty())
    return {};
  if (parts[0] > 31)
    return make_day(parts[0], parts[1], parts[2]);
  const auto year = century_of(parts[2], now);
  if (!year)
    return {};
  // A number above 12 in the middle must be the day: the month came first.
  return parts[1] > 12 ? make_day(*year, parts[0], parts[1])
                       : make_day(*year, parts[1], parts[0]);
}

std::optional<Day> day_of(Now now) {
  if (!now)
    return {};
  return read_day(format_timestamp(*now, "%Y-%m-%d"), '-', now);
}

Day last_of_month(Day day) {
  const year_month_day date(day);
  return Day(date.year() / date.month() / std::chrono::last);
}

Day months_later(Day day, int count) {
  const auto date = year_month_day(day) + std::chrono::months(count);
  // The month has no such day.
  return date.ok() ? Day(date)
                   : Day(date.year() / date.month() / std::chrono::last);
}

// "may" is a month although it is also a verb; the caller needs a day beside
// it.
std::int64_t month_of(std::string_view word) {
  if (word.size() < 3)
    return 0;
  // The first letter tells most apart.
  for (std::size_t index = 0; index < std::size(months); ++index)
    if (months[index][0] == word[0] && months[index].starts_with(word))
      return static_cast<std::int64_t>(index) + 1;
  return word == "sept" ? 9 : 0;
}

std::optional<std::chrono::weekday> weekday_of(std::string_view word) {
  if (word.size() < 3)
    return {};
  for (std::size_t index = 0; index < std::size(weekdays); ++index)
    if (weekdays[index][0] == word[0] &&
        (weekdays[index].starts_with(word) ||
         (word.ends_with('s') &&
          word.substr(0, word.size() - 1) == weekdays[index])))
      return std::chrono::weekday(static_cast<unsigned>(index));
  return {};
}

} // namespace parlour::adapters::nlu
