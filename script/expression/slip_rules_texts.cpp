#include <algorithm>
#include <cctype>

#include "script/expression/slip_rules.hpp"
#include "script/expression/slips.hpp"

namespace parlour::script::slip_rules {

bool is_operator_word(std::string_view word) {
  return is_reserved(word) || find_slip(SlipPlace::operation, word);
}

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

// Where nobody knows what is declared, a word that might compare or join does.
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

// The bytes of a typographic quotation mark that begins there; 0: none does.
std::size_t typographic_quote(std::string_view text) {
  if (text.size() > 2 && text[0] == '\xe2' && text[1] == '\x80' &&
      static_cast<unsigned char>(text[2]) >= 0x98 &&
      static_cast<unsigned char>(text[2]) <= 0x9f)
    return 3;
  return text.starts_with("\xc2\xab") || text.starts_with("\xc2\xbb") ? 2 : 0;
}

} // namespace

Found whole_text(const Scene& scene) {
  const auto text = trimmed(scene.text);
  const bool is_condition = scene.wanted == Wanted::condition;
  if (text.empty())
    return ExpressionSlip{
        0, 0,
        is_condition ? "a condition is expected, such as count gt 2, and the "
                       "value is empty"
                     : "an expression is expected and the value is empty; an "
                       "empty text is written ''"};
  if (!reads_like_text(scene, text))
    return {};
  if (is_condition)
    return ExpressionSlip{scene.text.find(text), text.size(),
                          "this reads like text, and a condition is expected, "
                          "such as door == 'open'"};
  auto quoted = quoted_text(text);
  return ExpressionSlip{scene.text.find(text), text.size(),
                        "this reads like text, and an expression is expected; "
                        "a text stands in quotes: " +
                            quoted,
                        quoted};
}

Found smart_quotes(const Scene& scene) {
  const auto length = typographic_quote(scene.rest());
  if (length == 0)
    return {};
  ExpressionSlip slip{scene.at, length,
                      "this is a typographic quotation mark; a text stands in "
                      "straight ones: 'text'"};
  for (auto end = scene.at + length; end < scene.text.size(); ++end)
    if (const auto closing = typographic_quote(scene.text.substr(end))) {
      const auto inner =
          scene.text.substr(scene.at + length, end - scene.at - length);
      slip.length = end + closing - scene.at;
      slip.replacement = quoted_text(inner);
      break;
    }
  return slip;
}

namespace {

bool is_letter(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) != 0;
}

bool is_apostrophe(std::string_view text, std::size_t at) {
  return text[at] == '\'' && at > 0 && at + 1 < text.size() &&
         is_letter(text[at - 1]) && is_letter(text[at + 1]);
}

// All apostrophes between letters escaped.
std::string without_apostrophes(std::string_view text) {
  std::string escaped;
  for (std::size_t i = 0; i < text.size(); ++i)
    escaped += is_apostrophe(text, i) ? "\\'" : string_of(text.substr(i, 1));
  return escaped;
}

} // namespace

// An apostrophe between letters ended the text too early.
Found apostrophe(const Scene& scene) {
  const auto text = scene.text;
  const bool open = scene.error.find("closing quote") != npos;
  const bool adjacent = scene.at > 0 && is_apostrophe(text, scene.at - 1);
  if (!open && !adjacent)
    return {};
  if (parse_expression(without_apostrophes(text)).node)
    for (std::size_t i = 0; i < text.size(); ++i)
      if (is_apostrophe(text, i))
        return ExpressionSlip{i, 1,
                              "this apostrophe ends the text; inside of quotes "
                              "it is written \\'",
                              "\\'"};
  if (!open)
    return {};
  return ExpressionSlip{scene.at, 1,
                        "the text that begins here has no closing quote; "
                        "expected another " +
                            std::string(1, text[scene.at])};
}

// {count gt 2}, whole.
Found in_braces(const Scene& scene) {
  const auto text = trimmed(scene.text);
  if (!text.starts_with('{') || closing_of(text, 0) != text.size() - 1)
    return {};
  const auto inner = trimmed(text.substr(1, text.size() - 2));
  const auto meant = mended(inner, scene.wanted);
  if (!meant || path_begin(inner, inner.size()) == 0)
    return {};
  return ExpressionSlip{scene.text.find(text), text.size(),
                        "an expression stands here without braces: " + *meant,
                        meant};
}

namespace {

// '@name', '#name': only where that is one.
bool is_marked_name(const Scene& scene) {
  const auto rest = scene.rest();
  if (!rest.starts_with('@') && !rest.starts_with('#'))
    return false;
  const auto end = word_end(rest, 1);
  return end > 1 && scene.is_declared &&
         scene.is_declared(string_of(rest.substr(1, end - 1)));
}

} // namespace

// $name, ${name}, {name}, @name: a variable is its name.
Found decorated_name(const Scene& scene) {
  auto begin = scene.at;
  const auto brace = scene.text.rfind('{', scene.at);
  if (!scene.rest().starts_with('$') && !is_marked_name(scene)) {
    if (scene.error.find("':'") == npos || brace == npos)
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
  return ExpressionSlip{
      begin, end + (braces ? 1 : 0) - begin,
      "in an expression a variable is its name alone: " + name, name};
}

namespace {

// "hello {n}" of Python -> 'hello ' + n; nothing where that computes nothing.
std::optional<std::string> joined_parts(std::string_view text) {
  std::string joined = text.starts_with('{') ? "''" : ""; // so that texts join
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

// f'hello {name}', r'text'.
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
  ExpressionSlip slip{begin, end + 2, "a text has no letter before its quotes"};
  slip.replacement = joined_parts(rest.substr(1, end - 1));
  if (slip.replacement)
    slip.message += "; it is joined by '+': " + *slip.replacement;
  return slip;
}

} // namespace parlour::script::slip_rules

namespace parlour::script {

bool reads_like_text(std::string_view text, const IsDeclared& is_declared) {
  bool knows = false;
  int words = 0;
  const auto look = [&](std::string_view word) {
    knows |= is_declared(std::string(word));
    words += !slip_rules::is_operator_word(word) &&
             !slip_rules::is_digit(word.front());
  };
  return slip_rules::is_made_of_words(text, look) && words > 1 && !knows;
}

} // namespace parlour::script
