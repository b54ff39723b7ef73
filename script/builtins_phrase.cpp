// Built-in functions for phrases: how numbers, lists, times and levels are
// said in English.
#include <array>
#include <cctype>
#include <cstdlib>

#include "runtime/base/clock.hpp"
#include "script/builtin_call.hpp"
#include "script/builtin_functions.hpp"

namespace parlour::script::builtins {

namespace {

constexpr std::array<const char*, 20> cardinals{
    "zero",    "one",     "two",       "three",    "four",
    "five",    "six",     "seven",     "eight",    "nine",
    "ten",     "eleven",  "twelve",    "thirteen", "fourteen",
    "fifteen", "sixteen", "seventeen", "eighteen", "nineteen"};
constexpr std::array<const char*, 20> ordinals{
    "zeroth",    "first",     "second",      "third",      "fourth",
    "fifth",     "sixth",     "seventh",     "eighth",     "ninth",
    "tenth",     "eleventh",  "twelfth",     "thirteenth", "fourteenth",
    "fifteenth", "sixteenth", "seventeenth", "eighteenth", "nineteenth"};
constexpr std::array<const char*, 10> tens{
    "",      "",      "twenty",  "thirty", "forty",
    "fifty", "sixty", "seventy", "eighty", "ninety"};

// Up to ninety-nine in words, beyond in digits.
std::string cardinal(std::int64_t number) {
  if (number < 0 || number > 99)
    return std::to_string(number);
  const auto n = static_cast<std::size_t>(number);
  if (n < 20)
    return cardinals[n];
  std::string text = tens[n / 10];
  return n % 10 ? text + " " + cardinals[n % 10] : text;
}

std::string ordinal_digits(std::int64_t number) {
  const auto rest = std::abs(number % 100);
  const auto last = rest % 10;
  const bool teen = rest > 10 && rest < 14;
  return std::to_string(number) + (teen        ? "th"
                                   : last == 1 ? "st"
                                   : last == 2 ? "nd"
                                   : last == 3 ? "rd"
                                               : "th");
}

std::string ordinal_words(std::int64_t number) {
  if (number < 0 || number > 99)
    return ordinal_digits(number);
  const auto n = static_cast<std::size_t>(number);
  if (n < 20)
    return ordinals[n];
  std::string text = tens[n / 10];
  if (n % 10)
    return text + " " + ordinals[n % 10];
  text.back() = 'i'; // twenty, twentieth
  return text + "eth";
}

bool is_vowel(char c) {
  return std::string_view("aeiouAEIOU").find(c) != std::string_view::npos;
}

// The last word's regular plural, and the irregular ones of everyday.
std::string plural(const std::string& noun) {
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 7>
      irregular{{{"person", "people"},
                 {"child", "children"},
                 {"man", "men"},
                 {"woman", "women"},
                 {"staff", "staff"},
                 {"foot", "feet"},
                 {"tooth", "teeth"}}};
  const auto blank = noun.rfind(' ');
  const auto start = blank == std::string::npos ? 0 : blank + 1;
  const auto word = std::string_view(noun).substr(start);
  for (const auto& [one, several] : irregular)
    if (word == one)
      return noun.substr(0, start) + std::string(several);
  if (word.empty())
    return noun;
  if (word.ends_with('y') && word.size() > 1 &&
      !is_vowel(word[word.size() - 2]))
    return noun.substr(0, noun.size() - 1) + "ies";
  for (auto ending : {"s", "x", "z", "ch", "sh"})
    if (word.ends_with(ending))
      return noun + "es";
  return noun + "s";
}

// "A, B and C".
std::string series(const std::vector<std::string>& parts,
                   const std::string& link) {
  std::string text;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (i > 0)
      text += i + 1 == parts.size() ? " " + link + " " : ", ";
    text += parts[i];
  }
  return text;
}

std::string spoken_level(std::int64_t level) {
  if (level == 0)
    return "the ground floor";
  return level < 0 ? "basement " + cardinal(-level)
                   : "the " + ordinal_words(level) + " floor";
}

// "10:30" or "10:30:00" as "10:30am"; as it is where it is no time.
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

// "2026-11-21" as "Saturday, 21 November".
std::string spoken_date(const std::string& text) {
  const auto noon = parse_timestamp(text + " 12:00");
  return noon ? format_timestamp(*noon, "%A, %-d %B") : text;
}

} // namespace

bool count(BuiltinCall& call) {
  std::int64_t number = 0;
  std::string noun;
  std::string several;
  if (!call.integer(0, number) || !call.text(1, noun) ||
      (call.has(2) && !call.text(2, several)))
    return false;
  if (number == 1)
    return call.give_text("one " + noun);
  const auto word = number == 0 ? "no" : cardinal(number);
  return call.give_text(word + " " + (call.has(2) ? several : plural(noun)));
}

bool ordinal(BuiltinCall& call) {
  std::int64_t number = 0;
  return call.integer(0, number) && call.give_text(ordinal_words(number));
}

bool list(BuiltinCall& call) {
  ListObject* elements = nullptr;
  std::string link = "and";
  if (call[0].is_unknown())
    return call.give_text("");
  if (!call.list(0, elements) || (call.has(1) && !call.text(1, link)))
    return false;
  std::vector<std::string> parts;
  const auto limit = call.machine.program->settings.limits.result;
  for (const auto& element : elements->elements)
    if (!print(parts.emplace_back(), element, limit))
      return call.room(limit + 1);
  return call.give_text(series(parts, link));
}

bool an(BuiltinCall& call) {
  std::string noun;
  if (!call.text(0, noun))
    return false;
  const bool vowel = !noun.empty() && is_vowel(noun[0]);
  return call.give_text((vowel ? "an " : "a ") + noun);
}

bool spoken(BuiltinCall& call) {
  std::string kind;
  std::string text;
  if (call.has(1) && !call[1].is_unknown() && !call.text(1, kind))
    return false;
  if (call[0].is_unknown())
    return call.give_text("");
  if (call[0].is_list()) {
    BuiltinCall alone{call.machine, call.name, call.arguments, 1, call.result};
    return list(alone);
  }
  if (!call.text(0, text))
    return false;
  const auto number = numeric(call[0]);
  const bool whole = number && number->is_integer;
  if (kind == "level" && whole)
    return call.give_text(spoken_level(number->integer));
  if (kind == "time")
    return call.give_text(spoken_time(text));
  if (kind == "date")
    return call.give_text(spoken_date(text));
  if (kind == "number" && whole)
    return call.give_text(cardinal(number->integer));
  return call.give_text(text);
}

} // namespace parlour::script::builtins
