// English number words. Sum adds words up; number_at feeds it from the tokens.
#include "adapters/nlu/forms/number_words.hpp"

#include <algorithm>
#include <charconv>
#include <utility>

#include "adapters/nlu/text/word_set.hpp"

namespace parlour::adapters::nlu {

namespace {

struct NumberWord {
  std::int64_t value;
  bool ordinal;
};

constexpr std::int64_t million = 1'000'000;
constexpr std::int64_t billion = 1'000 * million;

const WordMap<NumberWord>& number_words() {
  static const WordMap<NumberWord> table{
      {"zero", {0, false}},          {"nought", {0, false}},
      {"naught", {0, false}},        {"nil", {0, false}},
      {"one", {1, false}},           {"two", {2, false}},
      {"three", {3, false}},         {"four", {4, false}},
      {"five", {5, false}},          {"six", {6, false}},
      {"seven", {7, false}},         {"eight", {8, false}},
      {"nine", {9, false}},          {"ten", {10, false}},
      {"eleven", {11, false}},       {"twelve", {12, false}},
      {"thirteen", {13, false}},     {"fourteen", {14, false}},
      {"fifteen", {15, false}},      {"sixteen", {16, false}},
      {"seventeen", {17, false}},    {"eighteen", {18, false}},
      {"nineteen", {19, false}},     {"twenty", {20, false}},
      {"thirty", {30, false}},       {"forty", {40, false}},
      {"fourty", {40, false}},       {"fifty", {50, false}},
      {"sixty", {60, false}},        {"seventy", {70, false}},
      {"eighty", {80, false}},       {"ninety", {90, false}},
      {"hundred", {100, false}},     {"thousand", {1000, false}},
      {"million", {million, false}}, {"billion", {billion, false}},
      {"first", {1, true}},          {"hundredth", {100, true}},
      {"second", {2, true}},         {"third", {3, true}},
      {"fourth", {4, true}},         {"fifth", {5, true}},
      {"sixth", {6, true}},          {"seventh", {7, true}},
      {"eighth", {8, true}},         {"ninth", {9, true}},
      {"tenth", {10, true}},         {"eleventh", {11, true}},
      {"twelfth", {12, true}},       {"thirteenth", {13, true}},
      {"fourteenth", {14, true}},    {"fifteenth", {15, true}},
      {"sixteenth", {16, true}},     {"seventeenth", {17, true}},
      {"eighteenth", {18, true}},    {"nineteenth", {19, true}},
      {"twentieth", {20, true}},     {"thirtieth", {30, true}},
      {"fortieth", {40, true}},      {"fiftieth", {50, true}},
      {"sixtieth", {60, true}}};
  return table;
}

// Adds up number words from left to right, as long as each fits behind the ones
// before it. "two hundred five" is one number; "two five" is two.
//
// `current_` is the part below a thousand that is being built; `total_` holds
// the finished thousands, millions and billions.
class Sum {
public:
  // False if the word does not fit. An ordinal ends the number.
  bool take(const NumberWord& word) {
    if (done_ || !fits(word.value))
      return false;
    done_ = word.ordinal;
    return true;
  }
  std::int64_t value() const {
    return total_ + current_;
  }
  bool ordinal() const {
    return done_;
  }
  // Whether "and" may follow: "two hundred and five".
  bool takes_and() const {
    return !done_ && value() > 0 && current_ % 100 == 0;
  }

private:
  // Adds the value if it fits. A unit fits behind tens ("twenty" 3) but not
  // behind ten itself; tens and teens fit only behind hundreds.
  bool fits(std::int64_t value) {
    // "zero" stands alone.
    if (value == 0)
      return !std::exchange(begun_, true);
    if (value == 100)
      return scale(99, 100);
    if (value >= 1000)
      return thousands(value);
    const auto rest = current_ % 100;
    const bool fits = value < 10 ? rest % 10 == 0 && rest != 10 : rest == 0;
    // After "zero" nothing fits.
    if (!fits || (begun_ && value_is_zero()))
      return false;
    current_ += value;
    return begun_ = true;
  }

  bool value_is_zero() const {
    return value() == 0;
  }

  // "hundred" multiplies the units before it: "two hundred", "twelve hundred".
  bool scale(std::int64_t most, std::int64_t factor) {
    if (current_ > most || (begun_ && current_ == 0))
      return false;
    current_ = std::max<std::int64_t>(current_, 1) * factor;
    return begun_ = true;
  }

  // "thousand", "million" and "billion" close the part before them. They must
  // come in descending order.
  bool thousands(std::int64_t factor) {
    if (current_ == 0 || (total_ > 0 && total_ < factor * 1000))
      return false;
    total_ += current_ * factor;
    current_ = 0;
    return true;
  }

  std::int64_t total_ = 0;
  std::int64_t current_ = 0;
  bool begun_ = false;
  bool done_ = false;
};

// A token in digits, perhaps with the ending of an ordinal: "23rd".
std::optional<NumberAt> written_number(std::string_view word) {
  // Digits, then nothing or the ending of an ordinal.
  const auto end = word.find_first_not_of("0123456789");
  const auto value = digits_of(word.substr(0, end));
  if (!value)
    return {};
  const auto suffix = end == std::string_view::npos ? "" : word.substr(end);
  if (suffix.empty())
    return NumberAt{*value, 1, false, true};
  if (suffix == "st" || suffix == "nd" || suffix == "rd" || suffix == "th")
    return NumberAt{*value, 1, true, true};
  return {};
}

// The entry of a token in the table, or null.
const NumberWord* number_word(const Tokens& tokens, std::size_t position) {
  return position < tokens.list.size()
             ? number_words().find(tokens.list[position].word)
             : nullptr;
}

// Empty behind the last token.
std::string_view word_at(const Tokens& tokens, std::size_t position) {
  return position < tokens.list.size() ? tokens.list[position].word
                                       : std::string_view();
}

// In "a hundred" and "a thousand" the "a" means one.
bool is_article_of_number(const Tokens& tokens, std::size_t position) {
  const auto* scale = number_word(tokens, position + 1);
  return word_at(tokens, position) == "a" && scale && scale->value >= 100 &&
         !scale->ordinal;
}

} // namespace

bool is_number_word(std::string_view word) {
  return number_words().find(word) != nullptr;
}

std::optional<NumberAt> number_at(const Tokens& tokens, std::size_t position) {
  if (position >= tokens.list.size())
    return {};
  if (auto written = written_number(tokens.list[position].word))
    return written;
  Sum sum;
  auto at = position;
  // Only before "hundred" and above: "a five" is no number.
  if (is_article_of_number(tokens, position)) {
    sum.take({1, false});
    ++at;
  }
  while (at < tokens.list.size()) {
    // A comma or full stop ends the number.
    if (at > position && tokens.list[at].before != Break::none)
      break;
    // "and" belongs to the number only if another part follows that is smaller
    // than a hundred.
    const bool joins = sum.takes_and() && tokens.list[at].word == "and";
    const auto* word = number_word(tokens, joins ? at + 1 : at);
    if (!word || (joins && word->value >= 100) || !sum.take(*word))
      break;
    at += joins ? 2 : 1;
  }
  if (at == position)
    return {};
  return NumberAt{sum.value(), at - position, sum.ordinal(), false};
}

std::optional<NumberAt> collective_at(const Tokens& tokens,
                                      std::size_t position) {
  auto at = position;
  std::int64_t count = 1;
  const bool half = word_at(tokens, at) == "half";
  at += half ? 1U : 0U;
  const bool one = word_at(tokens, at) == "a";
  at += one ? 1U : 0U;
  if (!one && !half)
    if (const auto number = number_at(tokens, at)) {
      count = number->value;
      at += number->length;
    }
  // "couple" and "pair" are two; "dozen" may be counted or halved.
  const bool counted = at > position && !one && !half;
  const auto word = word_at(tokens, at++);
  const bool dozen = word == "dozen";
  if (!dozen && (half || counted || (word != "couple" && word != "pair")))
    return {};
  at += word_at(tokens, at) == "of" ? 1U : 0U;
  count *= dozen ? 12 : 2;
  return NumberAt{half ? count / 2 : count, at - position, false, false};
}

std::optional<int> digit_of(std::string_view word) {
  if (word == "oh" || word == "o")
    return 0;
  if (word.size() == 1 && word[0] >= '0' && word[0] <= '9')
    return word[0] - '0';
  const auto* const found = number_words().find(word);
  if (!found || found->ordinal || found->value > 9)
    return {};
  return static_cast<int>(found->value);
}

std::optional<std::int64_t> digits_of(std::string_view word) {
  if (word.empty() || word.size() > 15)
    return {};
  std::int64_t value = 0;
  const auto* end = word.data() + word.size();
  const auto result = std::from_chars(word.data(), end, value);
  if (result.ec != std::errc() || result.ptr != end || value < 0)
    return {};
  return value;
}

} // namespace parlour::adapters::nlu
