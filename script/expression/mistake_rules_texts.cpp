// Rules about strings, quotes, and texts that were meant as such.

#include <algorithm>
#include <cctype>

#include "script/expression/common_mistakes.hpp"
#include "script/expression/mistake_rules.hpp"

namespace parlour::script::mistake_rules {

bool is_operator_word(std::string_view word) {
  return is_reserved(word) || find_mistake(MistakePlace::operation, word);
}

// Blanks, hyphens and apostrophes may stand anywhere; other punctuation only
// behind a word. A text that begins with a quote is a string literal.
bool is_made_of_words(std::string_view text, const VisitWord& visit) {
  constexpr std::string_view anywhere = " -'", behind_words = ".,!?:";
  std::size_t words = 0;
  for (std::size_t at = 0; at < text.size();) {
    const auto end = word_end(text, at);
    if (end > at) {
      words += std::isalpha(static_cast<unsigned char>(text[at])) != 0;
      visit(text.substr(at, end - at));
      at = end;
    } else if (anywhere.find(text[at]) == npos &&
               (behind_words.find(text[at]) == npos || at == 0 ||
                anywhere.find(text[at - 1]) != npos)) {
      return false;
    } else {
      ++at;
    }
  }
  return words > 1 && text.front() != '\'' && text.find(' ') != npos;
}

namespace {

// As the public function of this name. If it is not known what is declared, the
// text must be free of operator words instead.
bool reads_like_text(const Scene& scene, std::string_view text) {
  if (scene.is_declared)
    return parlour::script::reads_like_text(text, scene.is_declared);
  bool computes = false;
  return is_made_of_words(text,
                          [&](std::string_view word) {
                            computes |= is_operator_word(word);
                          }) &&
         !computes;
}

// The length of a typographic quotation mark at the start of the text; 0 if
// there is none.
std::size_t typographic_quote(std::string_view text) {
  if (text.size() > 2 && text[0] == '\xe2' && text[1] == '\x80' &&
      static_cast<unsigned char>(text[2]) >= 0x98 &&
      static_cast<unsigned char>(text[2]) <= 0x9f)
    return 3;
  return text.starts_with("\xc2\xab") || text.starts_with("\xc2\xbb") ? 2 : 0;
}

} // namespace

// Explains an empty value, and plain words where an expression is expected.
// This rule looks at the whole text first, because the parser's error about the
// second word would help nobody.
Found whole_text(const Scene& scene) {
  const auto text = trimmed(scene.text);
  const bool is_condition = scene.wanted == Wanted::condition;
  if (text.empty())
    return ExpressionMistake{
        0, 0,
        is_condition ? "a condition is expected, such as count gt 2, and the "
                       "value is empty"
                     : "an expression is expected and the value is empty; an "
                       "empty text is written ''"};
  if (!reads_like_text(scene, text))
    return {};
  if (is_condition)
    return ExpressionMistake{
        scene.text.find(text), text.size(),
        "this reads like text, and a condition is expected, "
        "such as door == 'open'"};
  auto quoted = quoted_text(text);
  return ExpressionMistake{
      scene.text.find(text), text.size(),
      "this reads like text, and an expression is expected; "
      "a text stands in quotes: " +
          quoted,
      quoted};
}

// Explains “text” in typographic quotation marks, as word processors make them.
Found smart_quotes(const Scene& scene) {
  const auto length = typographic_quote(scene.rest());
  if (length == 0)
    return {};
  ExpressionMistake mistake{
      scene.at, length,
      "this is a typographic quotation mark; a text stands in "
      "straight ones: 'text'"};
  for (auto end = scene.at + length; end < scene.text.size(); ++end)
    if (const auto closing = typographic_quote(scene.text.substr(end))) {
      const auto inner =
          scene.text.substr(scene.at + length, end - scene.at - length);
      mistake.length = end + closing - scene.at;
      mistake.replacement = quoted_text(inner);
      break;
    }
  return mistake;
}

namespace {

bool is_letter(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) != 0;
}

// A single quote between two letters, as in it's.
bool is_apostrophe(std::string_view text, std::size_t at) {
  return text[at] == '\'' && at > 0 && at + 1 < text.size() &&
         is_letter(text[at - 1]) && is_letter(text[at + 1]);
}

// The text with an escape before each apostrophe between letters.
std::string without_apostrophes(std::string_view text) {
  std::string escaped;
  for (std::size_t i = 0; i < text.size(); ++i)
    escaped += is_apostrophe(text, i) ? "\\'" : string_of(text.substr(i, 1));
  return escaped;
}

} // namespace

// Explains 'it's': an apostrophe between letters ended the string too early.
// The proof is that the text parses once such apostrophes are escaped.
Found apostrophe(const Scene& scene) {
  const auto text = scene.text;
  // Either the string never ends, or a word follows the quote directly.
  const bool open = scene.fault == SyntaxFault::open_text;
  const bool adjacent = scene.at > 0 && is_apostrophe(text, scene.at - 1);
  if (!open && !adjacent)
    return {};
  if (parse_expression(without_apostrophes(text)).node)
    for (std::size_t i = 0; i < text.size(); ++i)
      if (is_apostrophe(text, i))
        return ExpressionMistake{
            i, 1,
            "this apostrophe ends the text; inside of quotes "
            "it is written \\'",
            "\\'"};
  if (!open)
    return {};
  return ExpressionMistake{scene.at, 1,
                           "the text that begins here has no closing quote; "
                           "expected another " +
                               std::string(1, text[scene.at])};
}

// Explains {count gt 2}: an attribute that is an expression takes no braces.
Found in_braces(const Scene& scene) {
  const auto text = trimmed(scene.text);
  if (!text.starts_with('{') || closing_of(text, 0) != text.size() - 1)
    return {};
  const auto inner = trimmed(text.substr(1, text.size() - 2));
  const auto meant = mended(inner, scene.wanted);
  if (!meant || path_begin(inner, inner.size()) == 0)
    return {};
  return ExpressionMistake{
      scene.text.find(text), text.size(),
      "an expression stands here without braces: " + *meant, meant};
}

namespace {

// Whether @name or #name stands here and the name is declared. Otherwise the
// sign may belong to a text.
bool is_marked_name(const Scene& scene) {
  const auto rest = scene.rest();
  if (!rest.starts_with('@') && !rest.starts_with('#'))
    return false;
  const auto end = word_end(rest, 1);
  return end > 1 && scene.is_declared &&
         scene.is_declared(string_of(rest.substr(1, end - 1)));
}

} // namespace

// Explains $name, ${name}, {name} and @name: a variable is written as its name
// alone.
Found decorated_name(const Scene& scene) {
  auto begin = scene.at;
  // In {name} the parser complains about the missing ':' of a map, so the place
  // is behind the brace.
  const auto brace = scene.text.rfind('{', scene.at);
  if (!scene.rest().starts_with('$') && !is_marked_name(scene)) {
    if (scene.sign != ':' || brace == npos)
      return {};
    begin = brace;
  }
  const auto inner = scene.text.find_first_not_of("${@#", begin);
  if (inner == npos)
    return {};
  const auto end = word_end(scene.text, inner);
  if (end == inner)
    return {};
  const auto name = string_of(scene.text.substr(inner, end - inner));
  const bool braces = scene.text[inner - 1] == '{';
  if (braces && (end >= scene.text.size() || scene.text[end] != '}'))
    return {};
  return ExpressionMistake{
      begin, end + (braces ? 1 : 0) - begin,
      "in an expression a variable is its name alone: " + name, name};
}

namespace {

// Python's "hello {n}" as 'hello ' + n; nothing if the result does not parse.
std::optional<std::string> joined_parts(std::string_view text) {
  std::string joined = text.starts_with('{') ? "''" : ""; // so that + joins
  const auto add = [&joined](const std::string& part) {
    joined += (joined.empty() ? "" : " + ") + part;
  };
  for (std::size_t at = 0; at < text.size();) {
    const auto open = std::min(text.find('{', at), text.size());
    const auto close = std::min(text.find('}', open), text.size());
    if (open > at)
      add("'" + string_of(text.substr(at, open - at)) + "'");
    const auto inner = text.substr(open, close - open);
    if (inner.size() > 1)
      add(inner.find(' ') == npos ? string_of(inner.substr(1))
                                  : "(" + string_of(inner.substr(1)) + ")");
    at = close + 1;
  }
  return parse_expression(joined).node ? std::optional(joined) : std::nullopt;
}

} // namespace

// Explains f'hello {name}' and r'text', the string prefixes of Python.
Found text_with_letter(const Scene& scene) {
  const auto rest = scene.rest();
  const auto begin = word_begin(scene.text, scene.at);
  if (scene.at - begin != 1 ||
      std::string_view("fFrRbBuU").find(scene.text[begin]) == npos ||
      !(rest.starts_with('\'') || rest.starts_with('"')))
    return {};
  const auto end = rest.find(rest.front(), 1);
  if (end == npos)
    return {};
  ExpressionMistake mistake{begin, end + 2,
                            "a text has no letter before its quotes"};
  mistake.replacement = joined_parts(rest.substr(1, end - 1));
  if (mistake.replacement)
    mistake.message += "; it is joined by '+': " + *mistake.replacement;
  return mistake;
}

} // namespace parlour::script::mistake_rules

namespace parlour::script {

// Numbers and operator words are no evidence for a text, so they do not count
// as words.
bool reads_like_text(std::string_view text, const IsDeclared& is_declared) {
  bool knows = false;
  int words = 0;
  const auto look = [&](std::string_view word) {
    knows |= is_declared(std::string(word));
    words += !mistake_rules::is_operator_word(word) &&
             !mistake_rules::is_digit(word.front());
  };
  return mistake_rules::is_made_of_words(text, look) && words > 1 && !knows;
}

} // namespace parlour::script
