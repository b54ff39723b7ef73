#include "script/expression/brace_slips.hpp"

#include <algorithm>

#include "script/expression/builtins.hpp"
#include "script/expression/slip_rules.hpp"
#include "script/expression/slips.hpp"

namespace parlour::script {

namespace {

using namespace slip_rules;

bool is_one_of(char c, std::string_view all) {
  return all.find(c) != npos;
}

// What stands between two braces.
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
  BraceSlip explained(std::size_t length) const;

private:
  bool means_something(std::size_t begin, std::size_t end) const;
  bool is_known(std::size_t begin, std::size_t end) const;
  std::size_t known_word() const;
  bool compares() const;
  std::optional<std::string>
  mended_by(const std::vector<ExpressionSlip>& slips) const;

  std::string_view text_;
  const KnownNames& known_;
  bool is_words_ = false;
  bool has_meaning_ = true; // each word, in an expression
};

// A field and what is called do.
bool Inside::means_something(std::size_t begin, std::size_t end) const {
  const auto word = text_.substr(begin, end - begin);
  return (begin > 0 && text_[begin - 1] == '.') ||
         text_.substr(end).starts_with('(') || is_operator_word(word) ||
         is_digit(word.front()) || find_slip(SlipPlace::operand, word) ||
         known_.variable(string_of(word));
}

// A variable, or a function that is called.
bool Inside::is_known(std::size_t begin, std::size_t end) const {
  const auto word = string_of(text_.substr(begin, end - begin));
  return known_.variable(word) || (text_.substr(end).starts_with('(') &&
                                   (is_builtin(word) || known_.function(word)));
}

// Where the first one is; npos: there is none.
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

// A sign that computes, between two operands: a = b.
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

// Elsewhere than in what is heard, other languages have braces, too.
bool Inside::is_meant(bool is_heard) const {
  if (text_.starts_with('%')) // of a template, told as such
    return false;
  if (known_word() == npos)
    return is_heard && !is_words_ && compares();
  return begins_with_known() || has_meaning_ || (is_heard && !is_words_);
}

std::string Inside::variable_meant() const {
  const auto at = std::min(known_word(), text_.size());
  auto end = word_end(text_, at);
  while (end + 1 < text_.size() && text_[end] == '.' &&
         word_end(text_, end + 1) > end + 1)
    end = word_end(text_, end + 1);
  return "for the variable write {" + string_of(text_.substr(at, end - at)) +
         "}";
}

// As it stands in a file, too: without what XML wants written otherwise.
std::optional<std::string>
Inside::mended_by(const std::vector<ExpressionSlip>& slips) const {
  auto result = string_of(text_);
  for (auto slip = slips.rbegin(); slip != slips.rend(); ++slip) {
    if (!slip->replacement)
      return {};
    result.replace(slip->offset, slip->length, *slip->replacement);
  }
  if (result.find_first_of("<>&'\"") != npos || !parse_expression(result).node)
    return {};
  return "{" + result + "}";
}

BraceSlip Inside::explained(std::size_t length) const {
  const auto parsed = parse_expression(text_);
  const auto slips =
      parsed.node ? std::vector<ExpressionSlip>()
                  : find_slips(text_, parsed, Wanted::value, known_.variable);
  // Words behind a name tell no more.
  const bool tells = !slips.empty() && (!is_words_ || has_meaning_);
  if (!tells)
    return {length, variable_meant()};
  return {length, slips.front().message,
          has_meaning_ ? mended_by(slips) : std::nullopt};
}

// Behind the brace that ends what begins at `at`; npos: none does. Braces and
// quotes inside belong to it where they fit, as in {'{}' + a}.
std::size_t brace_end(std::string_view text, std::size_t at) {
  const auto first = text.find('}', at);
  if (first == npos)
    return npos;
  const bool nests = text.substr(at + 1, first - at - 1).find('{') != npos;
  const auto close = nests ? closing_of(text, at) : first;
  return (close == npos ? first : close) + 1;
}

} // namespace

std::optional<BraceSlip> explain_brace(std::string_view text, std::size_t at,
                                       const KnownNames& known, bool is_heard) {
  const auto end = brace_end(text, at);
  if (end == npos) {
    const Inside rest(text.substr(at + 1), known);
    return rest.begins_with_known()
               ? std::optional(BraceSlip{1, rest.variable_meant()})
               : std::nullopt;
  }
  const Inside inside(text.substr(at + 1, end - at - 2), known);
  if (!inside.is_meant(is_heard))
    return {};
  return inside.explained(end - at);
}

} // namespace parlour::script
