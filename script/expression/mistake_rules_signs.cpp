#include <algorithm>

#include "script/expression/mistake_rules.hpp"

// Rules about operators and other signs.
namespace parlour::script::mistake_rules {

namespace {

// A foreign sign and its counterpart. Longer signs stand before their parts.
struct Sign {
  std::string_view written;
  std::string_view meant; // empty: no single correction
  std::string_view sentence;
};

constexpr Sign signs[] = {
    {"!==", "!=", "'!==' is written '!='"},
    {"===", "==", "'===' is written '=='"},
    {"<>", "!=", "'<>' is written '!='"},
    {"=>", ">=", "'=>' is written '>='"},
    {"=<", "<=", "'=<' is written '<='"},
    {"=!", "!=", "'=!' is written '!='"},
    {":=", "", "an expression changes nothing; a <set> assigns"},
    {"??", "", "'?\?' is written: isknown(a) ? a : b"},
    {"?:", "", "'?:' is written: isknown(a) ? a : b"},
    {"?.", ".",
     "'?.' is written with the point alone; a field of unknown is unknown"},
    {"->", ".", "'->' is written as a point: map.field"},
    {"::", ".", "'::' is written as a point"},
    {"**", "", "a power is written pow(base, exponent)"},
    {"^", "", "a power is written pow(base, exponent)"},
    {"//", "", "whole numbers are divided by integer(a / b)"},
    {"&", "and", "a single '&' has no meaning here; write 'and'"},
    {"|", "or", "a single '|' has no meaning here; write 'or'"},
    {"~", "", "'~' has no meaning here; texts are compared by == or matches()"},
    {"`", "", "a text stands in straight quotes: 'text'"},
    {"@", "", "'@' has no meaning here; a text stands in quotes: 'text'"},
    {"#", "", "'#' has no meaning here; a text stands in quotes: 'text'"},
    {"\\", "", "a backslash stands inside of quoted texts only"},
};

// Whether the text is a name with or without fields.
bool is_path(std::string_view text) {
  return !text.empty() && !is_digit(text.front()) &&
         path_begin(text, text.size()) == 0;
}

// The statement that assigns, for advice.
std::string set_to(std::string_view name, const std::string& value) {
  return "<set name=\"" + string_of(name) + "\" expr=\"" + value + "\"/>";
}

// Explains 'a' & 'b', which joins strings in Basic.
Found joined_by_ampersand(const Scene& scene) {
  const auto is_quote = [](char c) { return c == '\'' || c == '"'; };
  const auto before = scene.before();
  if (!scene.rest().starts_with('&') || before.empty())
    return {};
  const auto behind = trimmed(scene.rest().substr(1));
  if (behind.empty() || (!is_quote(before.back()) && !is_quote(behind.front())))
    return {};
  return ExpressionMistake{scene.at, 1, "texts are joined by '+'", "+"};
}

// Explains "name = value" where nothing can be compared: the author meant to
// assign.
Found assigned(const Scene& scene) {
  const auto name = scene.before();
  const auto value = string_of(trimmed(scene.rest().substr(1)));
  if (!is_path(name) || !parse_expression(value).node)
    return {};
  if (scene.wanted == Wanted::target)
    return ExpressionMistake{
        scene.at, 1, "the value stands in expr: " + set_to(name, value)};
  if (scene.wanted == Wanted::value)
    return ExpressionMistake{
        scene.at, 1,
        "'=' assigns nothing here; write the value alone, " + value +
            ", or '==' to compare"};
  return {};
}

// '=>' in brackets is a lambda or a map of another language, not a misspelt >=.
Found found_sign(const Sign& sign, std::size_t at, const Scene& scene) {
  ExpressionMistake mistake{at, sign.written.size(), string_of(sign.sentence)};
  if (sign.written == "=>" && open_bracket(scene.text, at) != npos)
    mistake.message =
        "'=>' has no meaning in brackets: a function is declared by "
        "<function>, a map is {'key': value}";
  else if (!sign.meant.empty())
    mistake.replacement = string_of(sign.meant);
  return mistake;
}

} // namespace

// Explains age++ and total += 2. The place of the parser's error differs: it
// stands behind the first sign of ++ and at the = of +=.
Found assignment(const Scene& scene) {
  const auto whole = trimmed(scene.text);
  const bool before = whole.starts_with("++") || whole.starts_with("--");
  const bool inside =
      scene.at > 0 && scene.text.substr(scene.at - 1).starts_with("++");
  const bool doubled =
      before || inside || whole.ends_with("++") || whole.ends_with("--");
  const bool combined =
      scene.rest().starts_with('=') && scene.previous() != '\0' &&
      std::string_view("+-*/%").find(scene.previous()) != npos;
  if (!doubled && !combined)
    return {};
  // Where the doubled or combined sign begins.
  const auto at = before     ? scene.text.find_first_of("+-")
                  : inside   ? scene.at - 1
                  : combined ? scene.at - 1
                             : scene.text.find_last_of("+-") - 1;
  const auto name =
      before ? trimmed(whole.substr(2)) : trimmed(scene.text.substr(0, at));
  if (!is_path(name))
    return ExpressionMistake{at, 2,
                             "an expression changes nothing; a <set> does"};
  const auto right = doubled ? "1" : string_of(trimmed(scene.rest().substr(1)));
  return ExpressionMistake{
      at, 2,
      "an expression changes nothing; write " +
          set_to(name, string_of(name) + " " +
                           string_of(scene.text.substr(at, 1)) + " " + right)};
}

// The parser may give up at any character of a sign that it knows in part, so
// the sign may begin a little before the place.
Found foreign_sign(const Scene& scene) {
  if (auto joined = joined_by_ampersand(scene))
    return joined;
  for (const auto& sign : signs)
    for (std::size_t back = 0; back < sign.written.size(); ++back)
      if (back <= scene.at &&
          scene.text.substr(scene.at - back).starts_with(sign.written))
        return found_sign(sign, scene.at - back, scene);
  return {};
}

// Explains escapes: a pattern whose backslash is not doubled, such as '\d', and
// the escape of JavaScript for a character, which has no braces.
Found escape(const Scene& scene) {
  if (scene.fault != SyntaxFault::escape)
    return {};
  const auto rest = scene.rest();
  const auto digits = rest.substr(std::min<std::size_t>(rest.size(), 2), 4);
  if (rest.starts_with("\\u") && digits.size() == 4 &&
      digits.find_first_not_of("0123456789abcdefABCDEF") == npos) {
    const auto meant = "\\u{" + string_of(digits) + "}";
    return ExpressionMistake{
        scene.at, 6, "a character's number stands in braces: " + meant, meant};
  }
  // Letters that follow a backslash in regular expressions.
  constexpr std::string_view of_patterns = "dDwWsSbBzAQE.?*+()[]{}|^$-/";
  if (rest.size() < 2 || of_patterns.find(rest[1]) == npos)
    return ExpressionMistake{scene.at, 2,
                             string_of(scene.error) +
                                 "; a backslash itself is written \\\\"};
  const auto meant = "\\" + string_of(rest.substr(0, 2));
  return ExpressionMistake{
      scene.at, 2, "a backslash in a text is written twice: " + meant, meant};
}

// Explains = at the start, as in spreadsheets, as an assignment, and as a
// comparison.
Found equals(const Scene& scene) {
  if (!scene.rest().starts_with('=') || scene.rest().starts_with("=="))
    return {};
  if (scene.before().empty())
    return ExpressionMistake{
        scene.at, 1, "an expression begins without '='; leave it out", ""};
  if (auto mistake = assigned(scene))
    return mistake;
  return ExpressionMistake{scene.at, 1, "'=' does not compare; write '=='",
                           "=="};
}

// Explains a semicolon; it is only removed if nothing follows.
Found semicolon(const Scene& scene) {
  if (!scene.rest().starts_with(';'))
    return {};
  ExpressionMistake mistake{scene.at, 1,
                            "nothing ends with ';' here; leave it out"};
  if (trimmed(scene.rest().substr(1)).empty())
    mistake.replacement = "";
  return mistake;
}

// Explains 2,5 for 2.5.
Found decimal_comma(const Scene& scene) {
  const auto rest = scene.rest();
  if (rest.size() < 2 || rest[0] != ',' || !is_digit(rest[1]) ||
      !is_digit(scene.previous()))
    return {};
  const auto begin = word_begin(scene.text, scene.at);
  const auto end = word_end(scene.text, scene.at + 1);
  auto number = string_of(scene.text.substr(begin, end - begin));
  number[scene.at - begin] = '.';
  return ExpressionMistake{begin, end - begin,
                           "a fraction is written with a point: " + number,
                           number};
}

// Explains .5 for 0.5.
Found leading_point(const Scene& scene) {
  const auto rest = scene.rest();
  if (rest.size() < 2 || rest[0] != '.' || !is_digit(rest[1]))
    return {};
  const auto end = word_end(scene.text, scene.at + 1);
  const auto number =
      "0" + string_of(scene.text.substr(scene.at, end - scene.at));
  return ExpressionMistake{scene.at, end - scene.at,
                           "a fraction has a digit before its point: " + number,
                           number};
}

} // namespace parlour::script::mistake_rules
