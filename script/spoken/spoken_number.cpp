// English numbers. A cardinal is built in groups of three digits from the
// largest scale down; all other forms start from the cardinal's words.

#include "script/spoken/spoken_number.hpp"

#include <array>
#include <cctype>
#include <utility>

namespace parlour::script {

namespace {

// The tables and rules of English.
constexpr std::array<const char*, 20> small{
    "zero",    "one",     "two",       "three",    "four",
    "five",    "six",     "seven",     "eight",    "nine",
    "ten",     "eleven",  "twelve",    "thirteen", "fourteen",
    "fifteen", "sixteen", "seventeen", "eighteen", "nineteen"};

constexpr std::array<const char*, 10> tens{
    "",      "",      "twenty",  "thirty", "forty",
    "fifty", "sixty", "seventy", "eighty", "ninety"};

struct Scale {
  std::int64_t value;
  const char* name;
};

constexpr std::array<Scale, 4> scales{{{1'000'000'000'000, " trillion"},
                                       {1'000'000'000, " billion"},
                                       {1'000'000, " million"},
                                       {1'000, " thousand"}}};

// A double has no more significant digits.
constexpr int max_digits = 15;
constexpr int max_zeros = 5;

// "forty two", without a hyphen: the words are for a voice.
std::string below_hundred(std::int64_t number) {
  const auto n = static_cast<std::size_t>(number);
  if (n < small.size())
    return small[n];
  const std::string text = tens[n / 10];
  return n % 10 ? text + " " + small[n % 10] : text;
}

// "two hundred and five": the British "and".
std::string below_thousand(std::int64_t number) {
  if (number < 100)
    return below_hundred(number);
  const auto text = below_hundred(number / 100) + " hundred";
  return number % 100 ? text + " and " + below_hundred(number % 100) : text;
}

// For non-negative numbers of at most fifteen digits. The British "and" stands
// before the last group if that is below a hundred: one thousand and five.
std::string whole_words(std::int64_t number) {
  std::string text;
  for (const auto& scale : scales)
    if (const auto group = number / scale.value) {
      text += (text.empty() ? "" : " ") + below_thousand(group) + scale.name;
      number %= scale.value;
    }
  if (text.empty())
    return below_thousand(number);
  if (number == 0)
    return text;
  return text + (number < 100 ? " and " : " ") + below_thousand(number);
}

// Digits after the point are spoken one by one.
std::string fraction_words(const std::string& digits) {
  std::string text;
  for (const char digit : digits)
    text += std::string(" ") + small[static_cast<std::size_t>(digit - '0')];
  return text.empty() ? text : " point" + text;
}

// "twenty" becomes "twentieth" and "five" becomes "fifth".
std::string ordinal_word(std::string word) {
  static constexpr std::array<std::pair<std::string_view, const char*>, 7>
      irregular{{{"one", "first"},
                 {"two", "second"},
                 {"three", "third"},
                 {"five", "fifth"},
                 {"eight", "eighth"},
                 {"nine", "ninth"},
                 {"twelve", "twelfth"}}};
  for (const auto& [cardinal, ordinal] : irregular)
    if (word == cardinal)
      return ordinal;
  if (word.ends_with('y'))
    word.replace(word.size() - 1, 1, "ie");
  return word + "th";
}

bool is_vowel(char c) {
  return std::string_view("aeiou").find(c) != std::string_view::npos;
}

// The regular plural of the last word, and a few frequent irregular ones.
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

} // namespace

// Digits beyond the fifteenth are rounded away.
std::string cardinal_words(const Decimal& number) {
  if (number.point > max_digits || number.point < -max_zeros)
    return decimal_text(number);
  const auto said = rounded(number, max_digits - number.point);
  return (said.negative ? "minus " : "") +
         whole_words(std::stoll(whole_digits(said))) +
         fraction_words(fraction_digits(said));
}

std::string cardinal_words(std::int64_t number) {
  return cardinal_words(decimal_of(number));
}

// Only the last word becomes an ordinal: "twenty third".
std::string ordinal_words(std::int64_t number) {
  const auto words = cardinal_words(number);
  const auto last = words.rfind(' ') + 1; // 0 if there is no blank
  return words.substr(0, last) + ordinal_word(words.substr(last));
}

// 1938 is read in pairs; 2005 and years outside of 1000 to 9999 as numbers.
std::string year_words(std::int64_t year) {
  const auto rest = year % 100;
  if (year < 1000 || year > 9999 || year % 1000 < 10)
    return cardinal_words(year);
  const auto century = below_hundred(year / 100);
  if (rest == 0)
    return century + " hundred";
  return century + (rest < 10 ? " oh " : " ") + below_hundred(rest);
}

// The last groups have four digits, so a number of six begins with two.
std::string digit_words(std::string_view text) {
  constexpr std::size_t group = 4;
  constexpr std::string_view between = " -.()/";
  std::string digits;
  for (const char c : text.substr(text.starts_with('+')))
    if (c >= '0' && c <= '9')
      digits += c;
    else if (between.find(c) == std::string_view::npos)
      return std::string(text);
  std::string words = text.starts_with('+') ? "plus" : "";
  for (std::size_t at = 0; at < digits.size(); ++at) {
    const bool begins_group = at > 1 && (digits.size() - at) % group == 0;
    words += words.empty() ? "" : begins_group ? ", " : " ";
    words += small[static_cast<std::size_t>(digits[at] - '0')];
  }
  return words;
}

// Zero is "no boxes"; only exactly 1 takes the singular.
std::string counted(const Decimal& number, const std::string& noun,
                    const std::string& several) {
  const bool is_one = number.digits == "1" && number.point == 1;
  const auto words = number.digits.empty() ? "no" : cardinal_words(number);
  return words + " " +
         (is_one            ? noun
          : several.empty() ? plural(noun)
                            : several);
}

// No comma before the link: "A, B and C".
std::string series(const std::vector<std::string>& parts,
                   std::string_view link) {
  std::string text;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (i > 0)
      text += i + 1 == parts.size() ? " " + std::string(link) + " " : ", ";
    text += parts[i];
  }
  return text;
}

} // namespace parlour::script
