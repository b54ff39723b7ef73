#include <cctype>

#include "script/slip_rules.hpp"
#include "script/slips.hpp"

namespace parlour::script::slip_rules {

namespace {

bool is_operator_word(std::string_view word) {
  return is_reserved(word) || find_slip(SlipPlace::operation, word);
}

// Words with blanks between and nothing that computes.
bool reads_like_text(std::string_view text) {
  constexpr std::string_view punctuation = " .,!?-:'";
  std::size_t words = 0;
  for (std::size_t at = 0; at < text.size();) {
    const auto end = word_end(text, at);
    if (end > at) {
      words += std::isalpha(static_cast<unsigned char>(text[at])) != 0;
      if (is_operator_word(text.substr(at, end - at)))
        return false;
      at = end;
    } else if (punctuation.find(text[at++]) == npos) {
      return false;
    }
  }
  return words > 1 && text.front() != '\'' && text.find(' ') != npos;
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
  if (text.empty())
    return ExpressionSlip{0, 0,
                          "an expression is expected and the value is empty; "
                          "an empty text is written ''"};
  if (!reads_like_text(text))
    return {};
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

// An apostrophe between letters ended the text too early.
Found apostrophe(const Scene& scene) {
  const auto text = scene.text;
  if (scene.error.find("closing quote") == npos)
    return {};
  const auto quote = text[scene.at];
  for (std::size_t i = 1; i + 1 < text.size(); ++i)
    if (text[i] == '\'' && quote == '\'' &&
        std::isalpha(static_cast<unsigned char>(text[i - 1])) &&
        std::isalpha(static_cast<unsigned char>(text[i + 1])))
      return ExpressionSlip{i, 1,
                            "this apostrophe ends the text; inside of quotes "
                            "it is written \\'",
                            "\\'"};
  return ExpressionSlip{scene.at, 1,
                        "the text that begins here has no closing quote; "
                        "expected another " +
                            std::string(1, quote)};
}

// $name, ${name}, {name}, %name%: a variable is its name.
Found decorated_name(const Scene& scene) {
  auto begin = scene.at;
  const auto brace = scene.text.rfind('{', scene.at);
  if (!scene.rest().starts_with('$')) {
    if (scene.error.find("':'") == npos || brace == npos)
      return {};
    begin = brace;
  }
  const auto inner = scene.text.find_first_not_of("${", begin);
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

} // namespace parlour::script::slip_rules
