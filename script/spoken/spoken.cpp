// One function for each kind. A function that cannot speak its value falls back
// to the number, and that to the printed form.

#include "script/spoken/spoken.hpp"

#include <algorithm>
#include <array>

#include "script/spoken/spoken_number.hpp"
#include "script/spoken/spoken_time.hpp"

namespace parlour::script {

namespace {

// The value as an integer; nothing if it has a fraction or is too large to be
// spoken.
std::optional<std::int64_t> whole(const ToSay& value) {
  if (!value.number || value.number->point > 15 ||
      !fraction_digits(*value.number).empty())
    return {};
  const auto size = std::stoll(whole_digits(*value.number));
  return value.number->negative ? -size : size;
}

std::string text(const ToSay& value) {
  return value.text;
}

std::string number(const ToSay& value) {
  return value.number ? cardinal_words(*value.number) : value.text;
}

// Amounts of money and the like: to two decimals.
std::string amount(const ToSay& value) {
  return value.number ? cardinal_words(rounded(*value.number, 2)) : value.text;
}

// Fractions have no ordinal and are spoken as numbers.
std::string ordinal(const ToSay& value) {
  const auto place = whole(value);
  return place ? ordinal_words(*place) : number(value);
}

std::string year(const ToSay& value) {
  const auto year = whole(value);
  return year ? year_words(*year) : number(value);
}

// Floors in British counting: 0 is the ground floor, negative ones are
// basements.
std::string level(const ToSay& value) {
  const auto level = whole(value);
  if (!level)
    return number(value);
  if (*level == 0)
    return "the ground floor";
  return *level < 0 ? "basement " + cardinal_words(-*level)
                    : "the " + ordinal_words(*level) + " floor";
}

std::string time(const ToSay& value) {
  return spoken_time(value.text);
}

std::string date(const ToSay& value) {
  return spoken_date(value.text, value.now);
}

std::string duration(const ToSay& value) {
  return value.number ? spoken_duration(*value.number) : value.text;
}

// With fewer than three digits it is not a telephone number.
std::string phone(const ToSay& value) {
  const auto digits = std::ranges::count_if(
      value.text, [](char c) { return c >= '0' && c <= '9'; });
  return digits < 3 ? value.text : digit_words(value.text);
}

std::string digits(const ToSay& value) {
  return digit_words(value.text);
}

std::string boolean(const ToSay& value) {
  return value.text == "true"    ? "yes"
         : value.text == "false" ? "no"
                                 : value.text;
}

struct Kind {
  std::string_view name;
  std::string (*say)(const ToSay& value);
};

constexpr std::array table{
#define SPOKEN(name, function, sentence) Kind{name, function},
#include "script/spoken/spoken.def"
#undef SPOKEN
};

const Kind* find_kind(std::string_view name) {
  const auto found = std::ranges::find(table, name, &Kind::name);
  return found == table.end() ? nullptr : &*found;
}

} // namespace

std::string spoken(const ToSay& value, std::string_view name) {
  const auto* kind = find_kind(name);
  return kind ? kind->say(value) : value.text;
}

bool is_spoken_kind(std::string_view kind) {
  return find_kind(kind) != nullptr;
}

const std::vector<std::string>& spoken_kinds() {
  static const auto names = [] {
    std::vector<std::string> all;
    for (const auto& kind : table)
      all.emplace_back(kind.name);
    return all;
  }();
  return names;
}

} // namespace parlour::script
