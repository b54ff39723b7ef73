// Rules about operator words of other languages, and about what is missing: a
// bracket, an operand, an operator.

#include <algorithm>

#include "script/expression/common_mistakes.hpp"
#include "script/expression/mistake_rules.hpp"

namespace parlour::script::mistake_rules {

// Explains "x not in list", which is written "not x in list".
Found not_in(const Scene& scene) {
  const auto end = word_end(scene.text, scene.at);
  if (scene.text.substr(scene.at, end - scene.at) != "not")
    return {};
  const auto next = scene.text.find_first_not_of(blanks, end);
  if (next == npos ||
      scene.text.substr(next, word_end(scene.text, next) - next) != "in")
    return {};
  const auto before = scene.before();
  const auto object = before.substr(path_begin(before, before.size()));
  if (object.empty())
    return ExpressionMistake{scene.at, 3, "'not' stands first: not x in list"};
  const auto from = static_cast<std::size_t>(object.data() - scene.text.data());
  const auto meant = "not " + string_of(object) + " in";
  return ExpressionMistake{from, next + 2 - from,
                           "'not' stands first: " + meant + " …", meant};
}

// Explains operator words such as `mod`, `equals` or `is not`, by the table.
Found word_of_other_language(const Scene& scene) {
  const auto end = word_end(scene.text, scene.at);
  const auto word = scene.text.substr(scene.at, end - scene.at);
  if (const auto* mistake = find_mistake(MistakePlace::operation, word)) {
    if (mistake->meant.empty())
      return ExpressionMistake{scene.at, word.size(),
                               "there is no '" + string_of(word) + "' here; " +
                                   string_of(mistake->sentence)};
    auto length = word.size();
    auto meant = string_of(mistake->meant);
    const auto next = scene.text.find_first_not_of(blanks, end);
    if (meant == "==" && next != npos && // "is not"
        scene.text.substr(next, word_end(scene.text, next) - next) == "not") {
      length = next + 3 - scene.at;
      meant = "!=";
    }
    return ExpressionMistake{
        scene.at, length,
        "'" + string_of(scene.text.substr(scene.at, length)) +
            "' is written '" + meant + "'",
        meant};
  }
  return {};
}

// Explains "NOT a" and "typeof a": the parser took the foreign word for a name,
// so it gave up at the word behind it.
Found word_before(const Scene& scene) {
  const auto before = scene.before();
  const auto begin = word_begin(before, before.size());
  const auto word = before.substr(begin);
  const auto* mistake = find_mistake(MistakePlace::operation, word);
  const auto at = static_cast<std::size_t>(word.data() - scene.text.data());
  if (mistake && mistake->meant.empty() &&
      scene.fault == SyntaxFault::unexpected)
    return ExpressionMistake{at, word.size(),
                             "there is no '" + string_of(word) + "' here; " +
                                 string_of(mistake->sentence)};
  if (!mistake || mistake->meant != "not")
    return {};
  return ExpressionMistake{at, word.size(),
                           "'" + string_of(word) + "' is written 'not'", "not"};
}

// Explains 5pm and 2nd.
Found number_with_letters(const Scene& scene) {
  if (scene.fault != SyntaxFault::letters_behind_number)
    return {};
  const auto begin = word_begin(scene.text, scene.at);
  const auto end = word_end(scene.text, scene.at);
  const auto word = string_of(scene.text.substr(begin, end - begin));
  return ExpressionMistake{begin, end - begin,
                           "'" + word +
                               "' is neither a number nor a name, which begins "
                               "with a letter; a text stands in quotes: '" +
                               word + "'"};
}

// Explains a bracket that is not closed: where it was opened if the text ends,
// else what is missing before the unexpected word.
Found unclosed_bracket(const Scene& scene) {
  const bool closing = scene.fault == SyntaxFault::missing &&
                       std::string_view(")]},").find(scene.sign) != npos;
  const auto open = open_bracket(scene.text, scene.at);
  if (!closing || open == npos)
    return {};
  const auto bracket = scene.text[open];
  const std::string close(1, bracket == '(' ? ')' : bracket == '[' ? ']' : '}');
  if (scene.at >= scene.text.size())
    return ExpressionMistake{open, 1,
                             "this '" + std::string(1, bracket) +
                                 "' is not closed; '" + close + "' is missing"};
  const auto end = std::max(word_end(scene.text, scene.at), scene.at + 1);
  return ExpressionMistake{
      scene.at, end - scene.at,
      (scene.sign == ',' ? "',' or '" : "an operator or '") + close +
          "' is missing before '" +
          string_of(scene.text.substr(scene.at, end - scene.at)) + "'"};
}

// Explains an expression that ends behind an operator or an open bracket, by
// naming the last sign.
Found early_end(const Scene& scene) {
  if (scene.fault != SyntaxFault::ends_early || scene.before().empty())
    return {};
  const auto before = scene.before();
  auto begin = word_begin(before, before.size());
  if (begin == before.size())
    --begin;
  constexpr std::string_view signs = "=!<>&|";
  while (begin > 0 && signs.find(before[begin]) != npos &&
         signs.find(before[begin - 1]) != npos)
    --begin;
  const auto at = scene.text.find_first_not_of(blanks) + begin;
  const auto last = string_of(before.substr(begin));
  if (const auto open = open_bracket(scene.text, scene.at); open == at)
    return ExpressionMistake{at, last.size(),
                             "this '" + last + "' is not closed"};
  return ExpressionMistake{at, last.size(),
                           "a value is missing behind '" + last + "'"};
}

// Explains two operands in a row. This is the most general rule and comes last.
Found missing_operator(const Scene& scene) {
  const auto rest = scene.rest();
  if (scene.fault != SyntaxFault::unexpected || rest.empty() ||
      scene.before().empty())
    return {};
  const bool is_text = rest[0] == '\'' || rest[0] == '"';
  if (!is_text && !is_word_byte(rest[0]))
    return {};
  const auto before = scene.before().back();
  if (!is_word_byte(before) && before != '\'' && before != '"' &&
      before != ')' && before != ']')
    return {};
  if (is_text || before == '\'' || before == '"')
    return ExpressionMistake{
        scene.at, 0, "an operator is missing before this; + joins texts"};
  const auto end = word_end(scene.text, scene.at);
  return ExpressionMistake{scene.at, end - scene.at,
                           "an operator such as + or and is missing before '" +
                               string_of(rest.substr(0, end - scene.at)) +
                               "', or quotes around a text"};
}

// Explains a bracket that closes nothing, or closes too early.
Found closing_bracket(const Scene& scene) {
  const auto rest = scene.rest();
  if (scene.fault != SyntaxFault::unexpected || rest.empty() ||
      std::string_view(")]}").find(rest[0]) == npos)
    return {};
  const bool opened = open_bracket(scene.text, scene.at) != npos;
  return ExpressionMistake{scene.at, 1,
                           opened ? "a value is missing before this '" +
                                        string_of(rest.substr(0, 1)) + "'"
                                  : "this '" + string_of(rest.substr(0, 1)) +
                                        "' closes nothing"};
}

} // namespace parlour::script::mistake_rules
