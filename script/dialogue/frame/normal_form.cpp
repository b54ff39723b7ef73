#include "script/dialogue/frame/normal_form.hpp"

#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>

#include <re2/re2.h>

namespace parlour::dialogue {

namespace {

using Convert = Value (*)(const Value& value);

std::string padded(const char* pattern, int a, int b, int c = 0) {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), pattern, a, b, c);
  return text.data();
}

std::string trimmed(const Value& value) {
  static const RE2 pattern(R"((?s)\s*(.*?)\s*)");
  std::string text;
  return RE2::FullMatch(value.text(), pattern, &text) ? text : std::string();
}

Value number(const Value& value) {
  if (value.if_integer() || value.if_number())
    return value;
  return value.if_string() ? parse_number(*value.if_string()) : Value();
}

// `half`: "a", "p", or empty on the clock of 24 hours. 12am is 00:00, 12pm is
// 12:00; 0pm and 13pm are no times.
Value clock_time(int hour, int minute, const std::string& half) {
  if (minute > 59 || hour > (half.empty() ? 23 : 12) ||
      (!half.empty() && hour == 0))
    return {};
  if (half == "p" && hour < 12)
    hour += 12;
  if (half == "a" && hour == 12)
    hour = 0;
  return padded("%02d:%02d", hour, minute);
}

// 10:30  9:05  10.30pm  10 a.m.  1030  1030hrs
Value time(const Value& value) {
  static const RE2 parts(
      R"((?i)(\d{1,2})[:.h](\d{2})(?::\d{2})?\s*(?:([ap])\.?\s*m\.?)?)");
  static const RE2 hour_only(R"((?i)(\d{1,2})\s*([ap])\.?\s*m\.?)");
  static const RE2 together(R"((?i)(\d{2})(\d{2})\s*(?:h|hrs|hours)?)");
  if (!value.if_string())
    return {};
  const auto text = trimmed(value);
  int hour = 0, minute = 0;
  std::string half;
  if (!RE2::FullMatch(text, parts, &hour, &minute, &half) &&
      !RE2::FullMatch(text, hour_only, &hour, &half) &&
      !RE2::FullMatch(text, together, &hour, &minute))
    return {};
  for (auto& letter : half)
    letter = static_cast<char>(letter | 0x20);
  return clock_time(hour, minute, half);
}

// 2026-11-21  21/11/2026  21.11.2026
Value date(const Value& value) {
  static const RE2 year_first(R"((\d{4})[-/.](\d{1,2})[-/.](\d{1,2}))");
  static const RE2 day_first(R"((\d{1,2})[-/.](\d{1,2})[-/.](\d{4}))");
  if (!value.if_string())
    return {};
  const auto text = trimmed(value);
  int year = 0, month = 0, day = 0;
  if (!RE2::FullMatch(text, year_first, &year, &month, &day) &&
      !RE2::FullMatch(text, day_first, &day, &month, &year))
    return {};
  const std::chrono::year_month_day all{
      std::chrono::year(year), std::chrono::month(static_cast<unsigned>(month)),
      std::chrono::day(static_cast<unsigned>(day))};
  return all.ok() ? Value(padded("%04d-%02d-%02d", year, month, day)) : Value();
}

// Whole seconds are integers. What is negative, endless or above 1e15 is no
// duration.
Value seconds(double amount) {
  if (!std::isfinite(amount) || amount < 0 || amount > 1e15)
    return {};
  if (amount == std::floor(amount))
    return static_cast<std::int64_t>(amount);
  return amount;
}

// The first letter tells the units of duration() apart; it has none for months.
double unit_in_seconds(char unit) {
  return unit == 'd' ? 86400 : unit == 'h' ? 3600 : unit == 'm' ? 60 : 1;
}

// Seconds: 90  1.5h  1h30m  20 min  2 hours  45 s
Value duration(const Value& value) {
  static const RE2 part(
      R"((?i)\s*(\d+(?:\.\d+)?)\s*)"
      R"((s|m|h|d|secs?|mins?|hrs?|seconds?|minutes?|hours?|days?)\b)");
  static const RE2 glued(R"((?i)\s*(\d+(?:\.\d+)?)([smhd]))");
  if (auto plain = number(value); !plain.is_unknown())
    return seconds(plain.number_or(-1));
  if (!value.if_string())
    return {};
  const auto text = trimmed(value);
  re2::StringPiece remaining(text);
  double amount = 0, sum = 0;
  std::string unit;
  while (RE2::Consume(&remaining, part, &amount, &unit) ||
         RE2::Consume(&remaining, glued, &amount, &unit))
    sum += amount * unit_in_seconds(static_cast<char>(unit[0] | 0x20));
  return remaining.empty() && !text.empty() ? seconds(sum) : Value();
}

// An integer; B1 is -1, L3 is 3, 2nd is 2.
Value level(const Value& value) {
  static const RE2 basement(R"((?i)b\s*(\d{1,3}))");
  static const RE2 above(R"((?i)(?:l|level\s)?\s*(\d{1,3})(?:st|nd|rd|th)?)");
  auto plain = number(value);
  if (!plain.is_unknown()) {
    auto amount = plain.number_or(0.5);
    return amount == std::floor(amount) && std::fabs(amount) < 1000
               ? Value(static_cast<std::int64_t>(amount))
               : Value();
  }
  int floor = 0;
  const auto text = trimmed(value);
  if (RE2::FullMatch(text, basement, &floor))
    return -floor;
  return RE2::FullMatch(text, above, &floor) ? Value(floor) : Value();
}

// Digits with an optional +, whatever stood between them.
Value phone(const Value& value) {
  static const RE2 written(R"(\+?[\d\s().\-/]+)");
  const auto text = trimmed(value);
  if (!RE2::FullMatch(text, written))
    return {};
  std::string digits;
  for (char c : text)
    if (c == '+' || (c >= '0' && c <= '9'))
      digits += c;
  const auto count = digits.size() - (digits.starts_with('+') ? 1 : 0);
  return count >= 3 && count <= 15 ? Value(digits) : Value();
}

Value email(const Value& value) {
  static const RE2 address(R"([\w.!#$%&'*+/=?^`{|}~-]+@)"
                           R"([A-Za-z0-9](?:[A-Za-z0-9-]*\.)+[A-Za-z]{2,})");
  const auto text = trimmed(value);
  return value.if_string() && RE2::FullMatch(text, address) ? Value(text)
                                                            : Value();
}

Value boolean(const Value& value) {
  if (value.if_boolean())
    return value;
  static const RE2 yes(R"((?i)\s*(yes|true)\s*)"),
      no(R"((?i)\s*(no|false)\s*)");
  if (RE2::FullMatch(value.text(), yes))
    return true;
  return RE2::FullMatch(value.text(), no) ? Value(false) : Value();
}

struct Form {
  std::string_view type;
  Convert convert;
};

constexpr std::array forms = {
    Form{"number", number}, Form{"date", date},         Form{"time", time},
    Form{"level", level},   Form{"duration", duration}, Form{"phone", phone},
    Form{"email", email},   Form{"boolean", boolean},
};

const Form* form_of(std::string_view type) {
  for (const auto& form : forms)
    if (form.type == type)
      return &form;
  return nullptr;
}

} // namespace

bool has_normal_form(std::string_view type) {
  return form_of(type) != nullptr;
}

Value normal_form(std::string_view type, const Value& value) {
  const auto* form = form_of(type);
  return form ? form->convert(value) : Value();
}

} // namespace parlour::dialogue
