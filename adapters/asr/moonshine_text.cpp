#include "adapters/asr/moonshine_text.hpp"

#include <algorithm>
#include <array>
#include <cctype>

#include "runtime/text/words.hpp"

namespace parlour::adapters::moonshine {

namespace {

// So many digits in a row are a number that was spelt: "one, two" may be two
// answers.
constexpr std::size_t fewest_digits = 3;
// So many digits of groups such as "9123-4567".
constexpr std::size_t long_number = 7;

bool is_digit(char one) {
  return one >= '0' && one <= '9';
}

bool same(std::string_view one, std::string_view other) {
  return std::ranges::equal(one, other, [](char a, char b) {
    return std::tolower(static_cast<unsigned char>(a)) == b;
  });
}

// A word and the punctuation behind it.
struct Word {
  std::string_view body;
  std::string_view end;
};

Word divided(std::string_view word) {
  const auto last = word.find_last_not_of(".,;:!?");
  const auto length = last == std::string_view::npos ? 0 : last + 1;
  return {word.substr(0, length), word.substr(length)};
}

// "nine" as "9", "9123" as it is; empty for what is no digits.
std::string digits_of(std::string_view part) {
  constexpr std::array<std::string_view, 10> names = {
      "zero", "one", "two",   "three", "four",
      "five", "six", "seven", "eight", "nine"};
  if (!part.empty() && std::ranges::all_of(part, is_digit))
    return std::string(part);
  const auto name = std::ranges::find_if(
      names, [&](std::string_view one) { return same(part, one); });
  if (name != names.end())
    return std::to_string(name - names.begin());
  return same(part, "oh") ? "0" : "";
}

// "Nine-one-two" as "912"; empty if a part is no digits.
std::string digits_of_parts(std::string_view body) {
  std::string digits;
  for (std::size_t at = 0; at <= body.size();) {
    const auto end = std::min(body.find('-', at), body.size());
    const auto part = digits_of(body.substr(at, end - at));
    if (part.empty())
      return {};
    digits += part;
    at = end + 1;
  }
  return digits;
}

// "good-by" as "goodbye", "a.m" (its last point is punctuation) as "am";
// "10.30" as "10:30"; "to-day", as it was once written, as "today".
std::string typed_word(const Word& word) {
  std::string body(word.body);
  if (same(body, "a.m") || same(body, "p.m"))
    return body.erase(1, 1);
  for (const std::string_view day : {"to-day", "to-night", "to-morrow"})
    if (same(body, day))
      return body.erase(2, 1);
  if (same(body, "good-by") || same(body, "good-bye"))
    return body.replace(4, body.npos, "bye");
  const auto point = body.find('.');
  const bool is_time = (point == 1 || point == 2) && body.size() == point + 3 &&
                       body[point + 1] < '6';
  if (is_time && std::ranges::count_if(body, is_digit) ==
                     static_cast<std::ptrdiff_t>(body.size() - 1))
    body[point] = ':';
  return body;
}

// Words from one on that are typed as one; `words` 0: there are none.
struct Joined {
  std::string text;
  std::size_t words = 0;
  std::string_view end; // the punctuation behind it
};

bool divides_sentences(std::string_view end) {
  return end.find_first_of(".!?;") != std::string_view::npos;
}

// A number, said digit by digit. Only commas may be between its words. Two
// words of several digits each are no number, unless it is a long one.
Joined number_at(const std::vector<std::string>& words, std::size_t first) {
  Joined number;
  bool one_by_one = true;
  for (auto at = first; at < words.size(); ++at) {
    const auto word = divided(words[at]);
    const auto digits = digits_of_parts(word.body);
    if (digits.empty())
      break;
    one_by_one &= digits.size() == 1 || word.body.find('-') != word.body.npos;
    number.text += digits;
    ++number.words;
    number.end = word.end;
    if (divides_sentences(word.end))
      break;
  }
  const auto least = one_by_one ? fewest_digits : long_number;
  return number.text.size() < least ? Joined() : number;
}

// At least two letters with a point each: "H. R." for "HR". The last one's
// point is gone, too.
Joined initials_at(const std::vector<std::string>& words, std::size_t first) {
  Joined initials;
  for (auto at = first; at < words.size(); ++at) {
    const auto [body, end] = divided(words[at]);
    if (body.size() != 1 ||
        !std::isupper(static_cast<unsigned char>(body[0])) ||
        !end.starts_with('.'))
      break;
    initials.text += body;
    ++initials.words;
    initials.end = end.substr(1);
    if (!initials.end.empty())
      break;
  }
  return initials.words < 2 ? Joined() : initials;
}

} // namespace

// From left to right: the longest number first, else initials, else one word.
std::string typed_text(std::string_view spoken) {
  const auto words = split_words(spoken);
  std::string text;
  for (std::size_t at = 0; at < words.size();) {
    if (at > 0)
      text += ' ';
    auto joined = number_at(words, at);
    if (joined.words == 0)
      joined = initials_at(words, at);
    if (joined.words > 0) {
      (text += joined.text) += joined.end;
      at += joined.words;
      continue;
    }
    const auto word = divided(words[at++]);
    const auto body = typed_word(word);
    // The point of "a.m." is gone, unless the sentence ends there.
    const bool is_within =
        body.size() + 1 == word.body.size() && at < words.size();
    text += body;
    text +=
        is_within && word.end.starts_with('.') ? word.end.substr(1) : word.end;
  }
  return text;
}

std::string
with_capitals(std::string_view text,
              const std::function<std::string(const std::string&)>& written) {
  std::string made;
  for (const auto& word : split_words(text)) {
    const auto [body, end] = divided(word);
    const auto spelt = written(std::string(body));
    if (!made.empty())
      made += ' ';
    // A word with capitals is not the same().
    made += same(spelt, body) ? std::string_view(spelt) : body;
    made += end;
  }
  return made;
}

} // namespace parlour::adapters::moonshine
