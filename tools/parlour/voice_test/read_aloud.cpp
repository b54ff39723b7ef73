#include "tools/parlour/voice_test/read_aloud.hpp"

#include <algorithm>
#include <cctype>

namespace parlour::tools {

namespace {

// Digits, perhaps in groups of four; fewer are a number or a year.
constexpr std::size_t fewest_digits = 5;

bool is_digit(char one) {
  return std::isdigit(static_cast<unsigned char>(one)) != 0;
}

// Behind the digits that begin here, with single blanks between groups.
std::size_t behind_digits(std::string_view line, std::size_t at) {
  while (at < line.size() &&
         (is_digit(line[at]) ||
          (line[at] == ' ' && at + 1 < line.size() && is_digit(line[at + 1]))))
    ++at;
  return at;
}

std::string one_by_one(std::string_view digits) {
  std::string text;
  for (const char one : digits)
    if (is_digit(one))
      (text += text.empty() ? "" : " ") += one;
  return text;
}

void replace_all(std::string& text, std::string_view from,
                 std::string_view to) {
  for (auto at = text.find(from); at != std::string::npos;
       at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
}

} // namespace

std::string read_aloud(std::string_view line) {
  std::string text;
  for (std::size_t at = 0; at < line.size();) {
    const auto end = is_digit(line[at]) ? behind_digits(line, at) : at;
    const auto digits = line.substr(at, end - at);
    const auto count = std::ranges::count_if(digits, is_digit);
    if (static_cast<std::size_t>(count) >= fewest_digits) {
      text += one_by_one(digits);
      at = end;
    } else {
      text += line[at++];
      while (at < end)
        text += line[at++];
    }
  }
  replace_all(text, " s/o ", " son of ");
  replace_all(text, " d/o ", " daughter of ");
  return text;
}

} // namespace parlour::tools
