#include "runtime/text/shifted_time.hpp"

#include <optional>
#include <string_view>

namespace parlour {

namespace {

constexpr int minutes_of_day = 24 * 60;

// "15:30", in minutes.
std::optional<int> minutes_in(std::string_view text) {
  const auto digit = [&](std::size_t at) { return text[at] - '0'; };
  if (text.size() != 5 || text[2] != ':')
    return {};
  for (const std::size_t at : {0U, 1U, 3U, 4U})
    if (digit(at) < 0 || digit(at) > 9)
      return {};
  return (digit(0) * 10 + digit(1)) * 60 + digit(3) * 10 + digit(4);
}

bool skip(std::string_view& text, std::string_view begin) {
  const bool found = text.starts_with(begin);
  text.remove_prefix(found ? begin.size() : 0);
  return found;
}

// Of "quarter to ten", ten.
int spoken_hour(int minutes) {
  return (minutes + 29) / 60 * 60;
}

} // namespace

std::string clock_text(std::int64_t minutes) {
  const auto day = (minutes % minutes_of_day + minutes_of_day) % minutes_of_day;
  const auto digit = [](std::int64_t number) {
    return static_cast<char>('0' + number);
  };
  return {digit(day / 600), digit(day / 60 % 10), ':', digit(day % 60 / 10),
          digit(day % 10)};
}

Value shifted_time(const Value& time, const Value& said) {
  if (!time.if_string() || !said.if_string())
    return {};
  std::string_view text = *said.if_string();
  const bool past = skip(text, "past ");
  const bool to = !past && skip(text, "to ");
  const bool later = !past && !to && skip(text, "+");
  const bool earlier = !past && !to && !later && skip(text, "-");
  const auto now = minutes_in(*time.if_string());
  const auto by = minutes_in(text);
  if (!now || !by || !(past || to || later || earlier))
    return {};
  const int from = past || to ? spoken_hour(*now) : *now;
  const int moved = past || later ? from + *by : from - *by;
  if (moved < 0 || moved >= minutes_of_day)
    return {};
  return clock_text(moved);
}

} // namespace parlour
