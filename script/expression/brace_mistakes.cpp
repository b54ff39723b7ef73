// How such braces are told from text:
//
//   "Hello {name"             a known name behind the brace: not closed
//   "{count + }"              a known name and an error: explained
//   "{so they say}"           words only: text
//   "{size: 3}"               nothing known in it: text, unless it is heard

#include "script/expression/brace_mistakes.hpp"

#include <algorithm>

#include "script/expression/builtins.hpp"
#include "script/expression/common_mistakes.hpp"
#include "script/expression/mistake_rules.hpp"

namespace parlour::script {

namespace {

using namespace mistake_rules;

bool is_one_of(char c, std::string_view all) {
  return all.find(c) != npos;
}

// The text between two braces, and what speaks for an expression in it. The
// words are classified once, in the constructor.
class Inside {
public:
  Inside(std::string_view text, const KnownNames& known)
      : text_(text), known_(known) {
    is_words_ = is_made_of_words(text_, [](std::string_view) {});
    for (std::size_t at = 0; at < text_.size();) {
      const auto end = word_end(text_, at);
      has_meaning_ &= end == at || means_something(at, end);
      at = std::max(end, at + 1);
    }
  }

  bool begins_with_known() const;
  bool is_meant(bool is_heard) const;
  std::string variable_meant() const;
  BraceMistake explained(std::size_t length) const;

private:
  bool means_something(std::size_t begin, std::size_t end) const;
  bool is_known(std::size_t begin, std::size_t end) const;
  std::size_t known_word() const;
  bool compares() const;
  std::optional<std::string>
  mended_by(const std::vector<ExpressionMistake>& mistakes) const;

  std::string_view text_;
  const KnownNames& known_;
  bool is_words_ = false;
  bool has_meaning_ = true; // every word means something in an expression
};

// Whether the word [begin, end) can be part of an expression: a field, a
// function call, an operator, a number, a literal of another language or a
// variable.
bool Inside::means_something(std::size_t begin, std::size_t end) const {
  const auto word = text_.substr(begin, end - begin);
  return (begin > 0 && text_[begin - 1] == '.') ||
         text_.substr(end).starts_with('(') || is_operator_word(word) ||
         is_digit(word.front()) || find_mistake(MistakePlace::operand, word) ||
         known_.variable(string_of(word));
}

// Whether the word is a variable, or a function that is called.
bool Inside::is_known(std::size_t begin, std::size_t end) const {
  const auto word = string_of(text_.substr(begin, end - begin));
  return known_.variable(word) || (text_.substr(end).starts_with('(') &&
                                   (is_builtin(word) || known_.function(word)));
}

// The offset of the first known word; npos if there is none. Fields do not
// count: any word may be one.
std::size_t Inside::known_word() const {
  for (std::size_t at = 0; at < text_.size();) {
    const auto end = word_end(text_, at);
    if (end > at && (at == 0 || text_[at - 1] != '.') && is_known(at, end))
      return at;
    at = std::max(end, at + 1);
  }
  return npos;
}

bool Inside::begins_with_known() const {
  const auto at = known_word();
  return at != npos && trimmed(text_.substr(0, at)).empty();
}

// Whether an operator stands between two operands, as in a = b.
bool Inside::compares() const {
  constexpr std::string_view computing = "=<>+*&|";
  const auto sign = text_.find_first_of(computing);
  if (sign == npos)
    return false;
  const auto before = trimmed(text_.substr(0, sign));
  const auto rest = text_.substr(sign);
  const auto behind = rest.find_first_not_of("=<>+*&| ");
  return !before.empty() && behind != npos &&
         (is_word_byte(before.back()) || is_one_of(before.back(), ")]'\"")) &&
         (is_word_byte(rest[behind]) || is_one_of(rest[behind], "(['\""));
}

// The decision. Texts that nobody hears or reads, such as files and messages to
// other programs, may hold braces of other formats, so there it takes more to
// speak of a mistake.
bool Inside::is_meant(bool is_heard) const {
  if (text_.starts_with('%')) // a template tag, reported as such
    return false;
  if (known_word() == npos)
    return is_heard && !is_words_ && compares();
  return begins_with_known() || has_meaning_ || (is_heard && !is_words_);
}

// The known name with its fields: {name.first}.
std::string Inside::variable_meant() const {
  const auto at = std::min(known_word(), text_.size());
  auto end = word_end(text_, at);
  while (end + 1 < text_.size() && text_[end] == '.' &&
         word_end(text_, end + 1) > end + 1)
    end = word_end(text_, end + 1);
  return "for the variable write {" + string_of(text_.substr(at, end - at)) +
         "}";
}

// The corrected expression in braces. Nothing if a mistake has no correction,
// or if the result holds characters that XML would need escaped.
std::optional<std::string>
Inside::mended_by(const std::vector<ExpressionMistake>& mistakes) const {
  auto result = string_of(text_);
  for (auto mistake = mistakes.rbegin(); mistake != mistakes.rend();
       ++mistake) {
    if (!mistake->replacement)
      return {};
    result.replace(mistake->offset, mistake->length, *mistake->replacement);
  }
  if (result.find_first_of("<>&'\"") != npos || !parse_expression(result).node)
    return {};
  return "{" + result + "}";
}

BraceMistake Inside::explained(std::size_t length) const {
  const auto parsed = parse_expression(text_);
  const auto mistakes =
      parsed.node
          ? std::vector<ExpressionMistake>()
          : find_mistakes(text_, parsed, Wanted::value, known_.variable);
  // The mistakes of mere words would not help: the parser complains about any
  // two words in a row.
  const bool tells = !mistakes.empty() && (!is_words_ || has_meaning_);
  if (!tells)
    return {length, variable_meant()};
  return {length, mistakes.front().message,
          has_meaning_ ? mended_by(mistakes) : std::nullopt};
}

// The offset behind the brace that closes the one at `at`; npos if none does.
// Braces and strings inside are skipped if they are balanced, as in {'{}' + a}.
std::size_t brace_end(std::string_view text, std::size_t at) {
  const auto first = text.find('}', at);
  if (first == npos)
    return npos;
  const bool nests = text.substr(at + 1, first - at - 1).find('{') != npos;
  const auto close = nests ? closing_of(text, at) : first;
  return (close == npos ? first : close) + 1;
}

} // namespace

// A brace that is not closed is only reported if a known name follows it at
// once.
std::optional<BraceMistake> explain_brace(std::string_view text, std::size_t at,
                                          const KnownNames& known,
                                          bool is_heard) {
  const auto end = brace_end(text, at);
  if (end == npos) {
    const Inside rest(text.substr(at + 1), known);
    return rest.begins_with_known()
               ? std::optional(BraceMistake{1, rest.variable_meant()})
               : std::nullopt;
  }
  const Inside inside(text.substr(at + 1, end - at - 2), known);
  if (!inside.is_meant(is_heard))
    return {};
  return inside.explained(end - at);
}

} // namespace parlour::script
