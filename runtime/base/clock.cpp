#include "runtime/base/clock.hpp"

#include <array>
#include <cmath>
#include <ctime>

#include "runtime/base/value.hpp"

namespace parlour {

namespace {

struct Unit {
  std::string_view suffix;
  double milliseconds;
};

// "ms" stands before "m" and "s" so that the longest suffix wins.
constexpr std::array units{Unit{"ms", 1}, Unit{"s", 1000}, Unit{"m", 60'000},
                           Unit{"h", 3'600'000}};

} // namespace

Timestamp SystemClock::now() const {
  using namespace std::chrono;
  return duration_cast<milliseconds>(system_clock::now().time_since_epoch())
      .count();
}

Expected<Timestamp> parse_timestamp(std::string_view text) {
  const std::string copy(text);
  for (const auto* pattern : {"%Y-%m-%d %H:%M:%S", "%Y-%m-%d %H:%M"}) {
    std::tm parts{};
    const auto* end = strptime(copy.c_str(), pattern, &parts);
    parts.tm_isdst = -1;
    const auto day = parts.tm_mday;
    const auto second = parts.tm_sec;
    // mktime normalises: it would turn 31 November into 1 December and second
    // 61 into the next minute. A date that mktime changed did not exist.
    const auto time = std::mktime(&parts);
    if (end && *end == '\0' && parts.tm_mday == day && parts.tm_sec == second)
      return static_cast<Timestamp>(time) * 1000;
  }
  return fail(ErrorKind::settings, "'" + copy +
                                       "' is not a time; write it as "
                                       "\"2026-11-21 09:00\"");
}

std::string format_timestamp(Timestamp time, const char* pattern) {
  auto seconds =
      static_cast<std::time_t>(std::floor(static_cast<double>(time) / 1000));
  std::tm parts{};
  localtime_r(&seconds, &parts);
  // strftime does not say how much room it needs and returns 0 if the text does
  // not fit, so the buffer doubles until it does.
  std::string text(64, '\0');
  while (text.size() <= 4096) {
    text.front() = '\0';
    auto length = std::strftime(text.data(), text.size(), pattern, &parts);
    if (length > 0 || *pattern == '\0') {
      text.resize(length);
      return text;
    }
    text.resize(text.size() * 2);
  }
  return {};
}

Expected<Milliseconds> parse_duration(std::string_view text) {
  for (const auto& unit : units) {
    if (!text.ends_with(unit.suffix))
      continue;
    auto number = parse_number(text.substr(0, text.size() - unit.suffix.size()))
                      .number_or(-1);
    if (number >= 0 && number < 1e12)
      return Milliseconds(std::llround(number * unit.milliseconds));
  }
  return fail(ErrorKind::settings, "'" + std::string(text) +
                                       "' is not a duration; write it as "
                                       "\"1.5s\", \"200ms\", \"2m\" or \"1h\"");
}

} // namespace parlour
