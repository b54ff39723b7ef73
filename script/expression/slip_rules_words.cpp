#include <algorithm>

#include "script/expression/slip_rules.hpp"
#include "script/expression/slips.hpp"

namespace parlour::script::slip_rules {

// x not in list.
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
    return ExpressionSlip{scene.at, 3, "'not' stands first: not x in list"};
  const auto from = static_cast<std::size_t>(object.data() - scene.text.data());
  const auto meant = "not " + string_of(object) + " in";
  return ExpressionSlip{from, next + 2 - from,
                        "'not' stands first: " + meant + " …", meant};
}

Found word_of_other_language(const Scene& scene) {
  const auto end = word_end(scene.text, scene.at);
  const auto word = scene.text.substr(scene.at, end - scene.at);
  if (const auto* slip = find_slip(SlipPlace::operation, word)) {
    if (slip->meant.empty())
      return ExpressionSlip{scene.at, word.size(),
                            "there is no '" + string_of(word) + "' here; " +
                                string_of(slip->sentence)};
    auto length = word.size();
    auto meant = string_of(slip->meant);
    const auto next = scene.text.find_first_not_of(blanks, end);
    if (meant == "==" && next != npos && // "is not"
        scene.text.substr(next, word_end(scene.text, next) - next) == "not") {
      length = next + 3 - scene.at;
      meant = "!=";
    }
    return ExpressionSlip{scene.at, length,
                          "'" + string_of(scene.text.substr(scene.at, length)) +
                              "' is written '" + meant + "'",
                          meant};
  }
  return {};
}

// NOT a, typeof a: what stands before the place was taken for a name.
Found word_before(const Scene& scene) {
  const auto before = scene.before();
  const auto begin = word_begin(before, before.size());
  const auto word = before.substr(begin);
  const auto* slip = find_slip(SlipPlace::operation, word);
  const auto at = static_cast<std::size_t>(word.data() - scene.text.data());
  if (slip && slip->meant.empty() &&
      scene.error.find("is not expected") != npos)
    return ExpressionSlip{at, word.size(),
                          "there is no '" + string_of(word) + "' here; " +
                              string_of(slip->sentence)};
  if (!slip || slip->meant != "not")
    return {};
  return ExpressionSlip{at, word.size(),
                        "'" + string_of(word) + "' is written 'not'", "not"};
}

Found number_with_letters(const Scene& scene) {
  if (scene.error.find("followed by letters") == npos)
    return {};
  const auto begin = word_begin(scene.text, scene.at);
  const auto end = word_end(scene.text, scene.at);
  const auto word = string_of(scene.text.substr(begin, end - begin));
  return ExpressionSlip{begin, end - begin,
                        "'" + word +
                            "' is neither a number nor a name, which begins "
                            "with a letter; a text stands in quotes: '" +
                            word + "'"};
}

Found unclosed_bracket(const Scene& scene) {
  const bool closing = scene.error.ends_with("is missing") &&
                       std::string_view(")]},").find(scene.error[1]) != npos;
  const auto open = open_bracket(scene.text, scene.at);
  if (!closing || open == npos || scene.error.size() < 3)
    return {};
  const auto bracket = scene.text[open];
  const std::string close(1, bracket == '(' ? ')' : bracket == '[' ? ']' : '}');
  if (scene.at >= scene.text.size())
    return ExpressionSlip{open, 1,
                          "this '" + std::string(1, bracket) +
                              "' is not closed; '" + close + "' is missing"};
  const auto end = std::max(word_end(scene.text, scene.at), scene.at + 1);
  return ExpressionSlip{
      scene.at, end - scene.at,
      (scene.error[1] == ',' ? "',' or '" : "an operator or '") + close +
          "' is missing before '" +
          string_of(scene.text.substr(scene.at, end - scene.at)) + "'"};
}

Found early_end(const Scene& scene) {
  if (scene.error.find("ends too early") == npos || scene.before().empty())
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
    return ExpressionSlip{at, last.size(), "this '" + last + "' is not closed"};
  return ExpressionSlip{at, last.size(),
                        "a value is missing behind '" + last + "'"};
}

Found missing_operator(const Scene& scene) {
  const auto rest = scene.rest();
  if (scene.error.find("is not expected here") == npos || rest.empty() ||
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
    return ExpressionSlip{scene.at, 0,
                          "an operator is missing before this; + joins texts"};
  const auto end = word_end(scene.text, scene.at);
  return ExpressionSlip{scene.at, end - scene.at,
                        "an operator such as + or and is missing before '" +
                            string_of(rest.substr(0, end - scene.at)) +
                            "', or quotes around a text"};
}

Found closing_bracket(const Scene& scene) {
  const auto rest = scene.rest();
  if (scene.error.find("is not expected here") == npos || rest.empty() ||
      std::string_view(")]}").find(rest[0]) == npos)
    return {};
  const bool opened = open_bracket(scene.text, scene.at) != npos;
  return ExpressionSlip{scene.at, 1,
                        opened ? "a value is missing before this '" +
                                     string_of(rest.substr(0, 1)) + "'"
                               : "this '" + string_of(rest.substr(0, 1)) +
                                     "' closes nothing"};
}

} // namespace parlour::script::slip_rules
