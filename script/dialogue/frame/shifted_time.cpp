#include "script/dialogue/frame/shifted_time.hpp"

#include <string>

#include <fmt/format.h>
#include <re2/re2.h>

namespace parlour::dialogue {

namespace {

constexpr int minutes_of_day = 24 * 60;

} // namespace

Value shifted_time(const Value& time, const Value& said) {
  static const RE2 clock(R"((\d{2}):(\d{2}))");
  static const RE2 difference(R"(([+-])(\d{2}):(\d{2}))");
  int hour = 0, minute = 0, hours = 0, minutes = 0;
  std::string sign;
  if (!said.if_string() || !time.if_string() ||
      !RE2::FullMatch(*said.if_string(), difference, &sign, &hours, &minutes) ||
      !RE2::FullMatch(*time.if_string(), clock, &hour, &minute))
    return {};
  const int by = (hours * 60 + minutes) * (sign == "-" ? -1 : 1);
  const int moved = hour * 60 + minute + by;
  if (moved < 0 || moved >= minutes_of_day)
    return {};
  return fmt::format("{:02}:{:02}", moved / 60, moved % 60);
}

} // namespace parlour::dialogue
