// Times in the twelve-hour clock, days by strftime, durations by unit.

#include "script/spoken/spoken_time.hpp"

#include <array>
#include <cstdlib>
#include <vector>

#include "script/spoken/spoken_number.hpp"

namespace parlour::script {

namespace {

constexpr Timestamp day = 86'400'000;
constexpr Timestamp half_a_year = 183 * day;

// Noon is used for a day, so that no change of the clock moves it to another
// one.
std::string year_of(Timestamp time) {
  return format_timestamp(time, "%Y");
}

struct Unit {
  std::int64_t seconds;
  const char* name;
};

constexpr std::array<Unit, 4> units{
    {{86'400, "day"}, {3'600, "hour"}, {60, "minute"}, {1, "second"}}};

} // namespace

// Seconds are accepted and not spoken.
std::string spoken_time(const std::string& text) {
  char* end = nullptr;
  const auto hour = std::strtol(text.c_str(), &end, 10);
  if (end == text.c_str() || *end != ':' || hour < 0 || hour > 23)
    return text;
  const auto* minutes = end + 1;
  const auto minute = std::strtol(minutes, &end, 10);
  if (end != minutes + 2 || minute < 0 || minute > 59 ||
      (*end != '\0' && *end != ':'))
    return text;
  const auto twelve = hour % 12 == 0 ? 12 : hour % 12;
  const std::string half = hour < 12 ? "am" : "pm";
  if (minute == 0)
    return std::to_string(twelve) + half;
  return std::to_string(twelve) + (minute < 10 ? ":0" : ":") +
         std::to_string(minute) + half;
}

std::string spoken_date(const std::string& text, Timestamp now) {
  const auto noon = parse_timestamp(text + " 12:00");
  if (!noon)
    return text;
  const bool near = std::abs(*noon - now) <= half_a_year;
  auto words = format_timestamp(*noon, near ? "%A, %-d %B" : "%-d %B");
  const auto year = year_of(*noon);
  if (!near || year != year_of(now))
    words += " " + year_words(std::atoll(year.c_str()));
  return words;
}

// Fractions of a second are spoken only if the whole duration is below a
// minute.
std::string spoken_duration(const Decimal& seconds) {
  if (seconds.negative || seconds.point > 15)
    return cardinal_words(seconds);
  if (std::stoll(whole_digits(seconds)) < 60)
    return seconds.digits.empty() ? "zero seconds" : counted(seconds, "second");
  // From the largest unit down; units with a count of zero are left out.
  auto left = std::stoll(whole_digits(rounded(seconds, 0)));
  std::vector<std::string> parts;
  for (const auto& unit : units) {
    if (const std::int64_t count = left / unit.seconds)
      parts.push_back(counted(decimal_of(count), unit.name));
    left %= unit.seconds;
  }
  return series(parts, "and");
}

} // namespace parlour::script
