// Dates: "today", "next monday", "21 november", "the 3rd of may 2027",
// "2026-11-21", "in two weeks".
#include <chrono>
#include <cstdio>

#include "adapters/nlu/form_reader.hpp"
#include "adapters/nlu/normal_forms.hpp"

namespace parlour::adapters::nlu {

namespace {

using std::chrono::days;
using std::chrono::sys_days;
using std::chrono::year_month_day;

constexpr std::string_view months[] = {
    "january", "february", "march",     "april",   "may",      "june",
    "july",    "august",   "september", "october", "november", "december"};

constexpr std::string_view weekdays[] = {"sunday",    "monday",   "tuesday",
                                         "wednesday", "thursday", "friday",
                                         "saturday"};

std::string date_text(sys_days day) {
  const year_month_day date(day);
  char text[32];
  std::snprintf(text, sizeof text, "%04d-%02u-%02u", int(date.year()),
                unsigned(date.month()), unsigned(date.day()));
  return text;
}

std::optional<sys_days> make_date(std::int64_t year, std::int64_t month,
                                  std::int64_t day) {
  if (year < 1900 || year > 2200 || month < 1 || day < 1 || day > 31)
    return {};
  const year_month_day date{std::chrono::year(static_cast<int>(year)),
                            std::chrono::month(static_cast<unsigned>(month)),
                            std::chrono::day(static_cast<unsigned>(day))};
  return date.ok() ? std::optional(sys_days(date)) : std::nullopt;
}

std::optional<sys_days> read_date(std::string_view text, char separator) {
  std::int64_t parts[3] = {0, 0, 0};
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
    return make_date(parts[0], parts[1], parts[2]);
  const auto year = parts[2] < 100 ? parts[2] + 2000 : parts[2];
  return parts[1] > 12 ? make_date(year, parts[0], parts[1])
                       : make_date(year, parts[1], parts[0]);
}

std::optional<sys_days> today(Now now) {
  if (!now)
    return {};
  return read_date(format_timestamp(*now, "%Y-%m-%d"), '-');
}

// 1 to 12; short names of three letters and more count, "may" only in full.
std::int64_t month_of(std::string_view word) {
  for (std::size_t index = 0; index < std::size(months); ++index)
    if (word.size() >= 3 && months[index].starts_with(word))
      return static_cast<std::int64_t>(index) + 1;
  return word == "sept" ? 9 : 0;
}

// 0 for sunday; -1 for none.
int weekday_of(std::string_view word) {
  for (std::size_t index = 0; index < std::size(weekdays); ++index)
    if (word.size() >= 3 && weekdays[index].starts_with(word) &&
        (word.size() >= 6 || word.size() <= 5))
      return static_cast<int>(index);
  return -1;
}

// The year that was said, else the one in which the day is still to come.
std::optional<FormAt> with_year(FormReader& reader, std::int64_t day,
                                std::int64_t month, Now now) {
  const auto year = digits_of(reader.word());
  if (year && *year >= 1900 && *year <= 2200) {
    reader.advance();
    const auto date = make_date(*year, month, day);
    return date ? std::optional(reader.form(date_text(*date))) : std::nullopt;
  }
  const auto current = today(now);
  if (!current)
    return {};
  const auto this_year = int(year_month_day(*current).year());
  auto date = make_date(this_year, month, day);
  if (date && *date < *current)
    date = make_date(this_year + 1, month, day);
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
    if (const auto date = read_date(word, separator))
      return reader.form(date_text(*date));
  }
  const auto slash = word.find('/');
  if (slash == std::string_view::npos)
    return {};
  const auto day = digits_of(word.substr(0, slash));
  const auto month = digits_of(word.substr(slash + 1));
  return day && month ? with_year(reader, *day, *month, now) : std::nullopt;
}

std::optional<FormAt> named_day(FormReader& reader, sys_days now) {
  if (reader.skip_all({"day", "after", "tomorrow"}))
    return reader.form(date_text(now + days(2)));
  if (reader.skip_any({"today", "tonight"}) ||
      reader.skip_all({"this", "morning"}) ||
      reader.skip_all({"this", "afternoon"}) ||
      reader.skip_all({"this", "evening"}))
    return reader.form(date_text(now));
  if (reader.skip_any({"tomorrow", "tmr", "tmrw"}))
    return reader.form(date_text(now + days(1)));
  if (reader.skip("yesterday"))
    return reader.form(date_text(now - days(1)));
  if (reader.skip_all({"next", "week"}))
    return reader.form(date_text(now + days(7)));
  return {};
}

// "friday" is the next one to come, "next friday" that of the next week; weeks
// begin on Monday.
std::optional<FormAt> day_of_week(FormReader& reader, sys_days now) {
  reader.skip_any({"this", "coming"});
  const bool next = reader.skip("next");
  const auto wanted = weekday_of(reader.word());
  if (wanted < 0)
    return {};
  reader.advance();
  const std::chrono::weekday current(now);
  const std::chrono::weekday day(static_cast<unsigned>(wanted));
  if (next) {
    const auto monday = now + days(8 - current.iso_encoding());
    return reader.form(date_text(monday + days(day.iso_encoding() - 1)));
  }
  const auto ahead = (day - current).count();
  return reader.form(date_text(now + days(ahead == 0 ? 7 : ahead)));
}

std::optional<FormAt> days_ahead(FormReader& reader, sys_days now) {
  if (!reader.skip("in"))
    return {};
  const bool one = reader.skip("a");
  const auto number = one ? std::nullopt : reader.number();
  if (!one && (!number || number->value > 1000))
    return {};
  const auto count = one ? 1 : static_cast<int>(number->value);
  if (reader.skip_any({"days", "day"}))
    return reader.form(date_text(now + days(count)));
  if (reader.skip_any({"weeks", "week"}))
    return reader.form(date_text(now + days(7 * count)));
  return {};
}

// "the 21st": this month or the next.
std::optional<FormAt> day_of_month(FormReader& reader, sys_days now) {
  if (!reader.skip("the"))
    return {};
  const auto day = reader.number();
  if (!day || !day->ordinal || day->value < 1 || day->value > 31)
    return {};
  auto month = year_month_day(now).year() / year_month_day(now).month();
  for (int tried = 0; tried < 3; ++tried, month += std::chrono::months(1)) {
    const auto date =
        make_date(int(month.year()), unsigned(month.month()), day->value);
    if (date && *date >= now)
      return reader.form(date_text(*date), true);
  }
  return {};
}

std::optional<FormAt> date_from_now(FormReader reader, sys_days now) {
  for (const auto read : {named_day, day_of_week, days_ahead, day_of_month}) {
    auto attempt = reader;
    if (read != day_of_month)
      attempt.skip("the");
    if (auto found = read(attempt, now))
      return found;
  }
  return {};
}

} // namespace

std::optional<FormAt> date_form(FormReader reader, Now now) {
  if (auto found = digital_date(reader, now))
    return found;
  if (auto found = day_and_month(reader, now))
    return found;
  if (auto found = month_and_day(reader, now))
    return found;
  const auto current = today(now);
  return current ? date_from_now(reader, *current) : std::nullopt;
}

} // namespace parlour::adapters::nlu
