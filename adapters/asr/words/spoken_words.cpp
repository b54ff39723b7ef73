#include "adapters/asr/words/spoken_words.hpp"

#include <array>
#include <cctype>
#include <charconv>
#include <optional>
#include <utility>

namespace parlour::adapters::asr {

namespace {

using Words = std::vector<std::string>;

constexpr std::array<std::string_view, 20> below_twenty{
    "zero",    "one",     "two",       "three",    "four",
    "five",    "six",     "seven",     "eight",    "nine",
    "ten",     "eleven",  "twelve",    "thirteen", "fourteen",
    "fifteen", "sixteen", "seventeen", "eighteen", "nineteen"};
constexpr std::array<std::string_view, 10> tens{
    "",      "",      "twenty",  "thirty", "forty",
    "fifty", "sixty", "seventy", "eighty", "ninety"};
constexpr std::array<std::string_view, 20> ordinals{
    "zeroth",    "first",     "second",      "third",      "fourth",
    "fifth",     "sixth",     "seventh",     "eighth",     "ninth",
    "tenth",     "eleventh",  "twelfth",     "thirteenth", "fourteenth",
    "fifteenth", "sixteenth", "seventeenth", "eighteenth", "nineteenth"};
// What is written shorter than it is said.
// Words without a point, as signs divide words: "Dr." comes as "dr".
constexpr std::array<std::pair<std::string_view, std::string_view>, 16>
    short_for{{{"dr", "doctor"},
               {"mr", "mister"},
               {"mrs", "missus"},
               {"ms", "miss"},
               {"prof", "professor"},
               {"mdm", "madam"},
               {"&", "and"},
               {"+", "plus"},
               {"%", "percent"},
               {"@", "at"},
               {"am", "am"},
               {"st", "street"},
               {"rd", "road"},
               {"ave", "avenue"},
               {"no", "no"},
               {"vs", "versus"}}};

void append(Words& to, const Words& words) {
  to.insert(to.end(), words.begin(), words.end());
}

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

// Bytes of other characters belong to words.
bool is_letter(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) ||
         static_cast<unsigned char>(c) >= 0x80;
}

std::optional<long long> number_at(std::string_view text, std::size_t& at) {
  long long number = 0;
  const auto [end, error] =
      std::from_chars(text.data() + at, text.data() + text.size(), number);
  if (error != std::errc{})
    return {};
  at = static_cast<std::size_t>(end - text.data());
  return number;
}

// "am", "pm" and "a.m." behind a time.
// "am" in "amount" is none: no letter may follow.
std::string half_of_day(std::string_view rest, std::size_t& length) {
  for (const auto* const sign : {"am", "pm", "a.m.", "p.m.", "a.m", "p.m"}) {
    const std::string_view form(sign);
    const auto end = form.size();
    if (rest.starts_with(form) &&
        (rest.size() == end || !is_letter(rest[end]))) {
      length = end;
      return form[0] == 'a' ? "a.m." : "p.m.";
    }
  }
  length = 0;
  return {};
}

Words minutes_in_words(long long minutes) {
  if (minutes == 0)
    return {};
  if (minutes < 10)
    return {"oh", std::string(below_twenty[static_cast<std::size_t>(minutes)])};
  return number_in_words(minutes);
}

Words digits_in_words(std::string_view digits) {
  Words words;
  for (const auto digit : digits)
    words.emplace_back(below_twenty[static_cast<std::size_t>(digit - '0')]);
  return words;
}

// Reads one text from left to right.
// What is neither a letter nor a digit divides words, unless it has a word of
// its own ("&").
class Reader {
public:
  explicit Reader(std::string_view text) {
    for (const auto c : text)
      text_ += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }

  Words read() {
    while (at_ < text_.size())
      if (is_digit(text_[at_]))
        number();
      else if (is_letter(text_[at_]))
        word();
      else
        sign();
    return std::move(words_);
  }

private:
  std::string_view rest() const {
    return std::string_view(text_).substr(at_);
  }

  // "2026" is a number, "64785056" a row of digits, and so is "007": what has
  // more than four digits or a leading zero is read out.
  void number() {
    const auto begin = at_;
    while (at_ < text_.size() && is_digit(text_[at_]))
      ++at_;
    const auto digits = std::string_view(text_).substr(begin, at_ - begin);
    auto from = begin;
    const auto value = number_at(text_, from);
    if (clock_time(value) || ordinal(value))
      return;
    if (!value || digits.size() > 4 || (digits.size() > 1 && digits[0] == '0'))
      append(words_, digits_in_words(digits));
    else
      append(words_, number_in_words(*value));
    day_half();
  }

  // ":30" behind an hour.
  bool clock_time(std::optional<long long> hour) {
    if (!hour || *hour > 24 || rest().size() < 3 ||
        (text_[at_] != ':' && text_[at_] != '.') || !is_digit(text_[at_ + 1]) ||
        !is_digit(text_[at_ + 2]) ||
        (rest().size() > 3 && is_digit(text_[at_ + 3])))
      return false;
    auto from = at_ + 1;
    const auto minutes = number_at(text_, from);
    at_ += 3;
    append(words_, number_in_words(*hour));
    append(words_, minutes_in_words(*minutes));
    if (!day_half() && *minutes == 0)
      words_.emplace_back("o'clock");
    return true;
  }

  // "2nd" is "second"; "23rd", "twenty third".
  bool ordinal(std::optional<long long> value) {
    for (const auto* const ending : {"st", "nd", "rd", "th"})
      if (value && rest().starts_with(ending) &&
          (rest().size() == 2 || !is_letter(text_[at_ + 2]))) {
        at_ += 2;
        append(words_, ordinal_in_words(*value));
        return true;
      }
    return false;
  }

  // Blanks between the time and "am" are skipped.
  bool day_half() {
    auto from = at_;
    while (from < text_.size() && text_[from] == ' ')
      ++from;
    std::size_t length = 0;
    auto half = half_of_day(std::string_view(text_).substr(from), length);
    if (half.empty())
      return false;
    at_ = from + length;
    words_.push_back(std::move(half));
    return true;
  }

  // "don't" is one word; an apostrophe at the end is a quotation mark.
  void word() {
    const auto begin = at_;
    while (at_ < text_.size() &&
           (is_letter(text_[at_]) ||
            (text_[at_] == '\'' && at_ + 1 < text_.size() &&
             is_letter(text_[at_ + 1]))))
      ++at_;
    add(text_.substr(begin, at_ - begin));
  }

  void sign() {
    add(std::string(1, text_[at_]));
    ++at_;
  }

  void add(std::string found) {
    for (const auto& [written, said] : short_for)
      if (written == found) {
        words_.emplace_back(said);
        return;
      }
    if (is_letter(found[0]))
      words_.push_back(std::move(found));
  }

  std::string text_;
  std::size_t at_ = 0;
  Words words_;
};

} // namespace

std::vector<std::string> spoken_words(std::string_view text) {
  return Reader(text).read();
}

// "one thousand two hundred thirty four", as Americans say it: without "and".
std::vector<std::string> number_in_words(long long number) {
  if (number < 0 || number >= 1'000'000'000)
    return {};
  if (number < 20)
    return {std::string(below_twenty[static_cast<std::size_t>(number)])};
  Words words;
  if (number < 100) {
    words.emplace_back(tens[static_cast<std::size_t>(number / 10)]);
    if (number % 10)
      append(words, number_in_words(number % 10));
    return words;
  }
  constexpr std::array<std::pair<long long, std::string_view>, 3> sizes{
      {{1'000'000, "million"}, {1'000, "thousand"}, {100, "hundred"}}};
  for (const auto& [size, name] : sizes)
    if (number >= size) {
      append(words, number_in_words(number / size));
      words.emplace_back(name);
      number %= size;
    }
  if (number)
    append(words, number_in_words(number));
  return words;
}

std::vector<std::string> ordinal_in_words(long long number) {
  if (number < 0 || number > 99)
    return number_in_words(number);
  if (number < 20)
    return {std::string(ordinals[static_cast<std::size_t>(number)])};
  const std::string ten(tens[static_cast<std::size_t>(number / 10)]);
  if (number % 10)
    return {ten, std::string(ordinals[static_cast<std::size_t>(number % 10)])};
  return {ten.substr(0, ten.size() - 1) + "ieth"};
}

} // namespace parlour::adapters::asr
