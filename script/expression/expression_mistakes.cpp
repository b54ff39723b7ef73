// Asks the rules in turn what an error means, corrects it and goes on. An
// example in which two mistakes are found one after the other:
//
//   a === b || c =< 2         '===' is written '=='
//   a == b || c =< 2          '=<' is written '<='
//   a == b || c <= 2          well-formed: both corrections are offered

#include "script/expression/expression_mistakes.hpp"

#include <cctype>

#include "script/expression/mistake_rules.hpp"

namespace parlour::script {

// Helpers on characters and words that the rules share.
namespace mistake_rules {

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

bool is_word_byte(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) || c == '_' ||
         static_cast<unsigned char>(c) >= 0x80;
}

std::size_t word_end(std::string_view text, std::size_t at) {
  while (at < text.size() && is_word_byte(text[at]))
    ++at;
  return at;
}

std::size_t word_begin(std::string_view text, std::size_t end) {
  while (end > 0 && is_word_byte(text[end - 1]))
    --end;
  return end;
}

std::size_t path_begin(std::string_view text, std::size_t end) {
  while (end > 0 && (is_word_byte(text[end - 1]) || text[end - 1] == '.'))
    --end;
  return end;
}

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(blanks);
  if (first == npos)
    return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::string string_of(std::string_view text) {
  return std::string(text);
}

} // namespace mistake_rules

namespace {

using namespace mistake_rules;

constexpr int max_mistakes = 8; // of one expression

// The rules in order of priority: the first that applies explains the error, so
// particular rules come before general ones. The last ones fit nearly
// everything.
constexpr Found (*rules[])(const Scene&) = {whole_text,
                                            smart_quotes,
                                            apostrophe,
                                            in_braces,
                                            assignment,
                                            semicolon,
                                            escape,
                                            filter,
                                            not_in,
                                            decorated_name,
                                            foreign_sign,
                                            equals,
                                            method,
                                            word_before,
                                            word_of_other_language,
                                            round_list,
                                            comma_in_index,
                                            decimal_comma,
                                            leading_point,
                                            slice_of_list,
                                            half_a_choice,
                                            layout_of_value,
                                            number_with_letters,
                                            unclosed_bracket,
                                            early_end,
                                            closing_bracket,
                                            text_with_letter,
                                            missing_operator};

// If no rule applies, the parser's own message is used.
ExpressionMistake explain(const Scene& scene) {
  for (const auto rule : rules)
    if (auto mistake = rule(scene))
      return *mistake;
  return {scene.at, 0, string_of(scene.error)};
}

} // namespace

std::string quoted_text(std::string_view text) {
  std::string quoted = "'";
  for (const char c : text) {
    if (c == '\'' || c == '\\')
      quoted += '\\';
    quoted += c;
  }
  return quoted + "'";
}

// The loop keeps three things in step: `mended` is the text with the
// corrections so far; `error` and `at` are the parser's complaint about it; and
// `longer` is how much longer it is than the original before the current place,
// which translates offsets back. It ends when nothing is wrong any more, a
// mistake has no correction, or the next mistake would lie before the last.
std::vector<ExpressionMistake> find_mistakes(std::string_view text,
                                             const Parsed& parsed,
                                             Wanted wanted,
                                             const IsDeclared& is_declared) {
  std::vector<ExpressionMistake> mistakes;
  std::string mended(text);
  std::ptrdiff_t longer = 0; // `mended` than `text`, up to the current place
  std::string error = parsed.error;
  std::size_t at = parsed.error_offset;
  auto fault = parsed.fault;
  auto sign = parsed.sign;
  while (!error.empty() && mistakes.size() < max_mistakes) {
    auto mistake =
        explain({mended, at, error, fault, sign, wanted, is_declared});
    const auto place = static_cast<std::ptrdiff_t>(mistake.offset) - longer;
    if (place < 0 ||
        (!mistakes.empty() &&
         place <= static_cast<std::ptrdiff_t>(mistakes.back().offset)))
      break; // the last correction was wrong then
    const auto begin = mistake.offset;
    mistake.offset = static_cast<std::size_t>(place);
    mistakes.push_back(mistake);
    if (!mistake.replacement)
      break;
    mended.replace(begin, mistake.length, *mistake.replacement);
    longer += static_cast<std::ptrdiff_t>(mistake.replacement->size()) -
              static_cast<std::ptrdiff_t>(mistake.length);
    const auto again = parse_expression(mended);
    error = again.error;
    at = again.error_offset;
    fault = again.fault;
    sign = again.sign;
    if (mended.substr(at, 1) == ",")
      break; // a list of arguments is no expression
  }
  // If errors remain, the corrections led nowhere and none of them is offered.
  if (!error.empty() && !parse_arguments(mended).node)
    for (auto& mistake : mistakes)
      mistake.replacement.reset();
  return mistakes;
}

// Applied from the end, so that earlier offsets stay valid.
std::optional<std::string> mended(std::string_view text, Wanted wanted) {
  const auto parsed = parse_expression(text);
  std::string result(text);
  if (parsed.node)
    return result;
  const auto mistakes = find_mistakes(text, parsed, wanted);
  for (auto mistake = mistakes.rbegin(); mistake != mistakes.rend();
       ++mistake) {
    if (!mistake->replacement)
      return {};
    result.replace(mistake->offset, mistake->length, *mistake->replacement);
  }
  return parse_expression(result).node ? std::optional(result) : std::nullopt;
}

} // namespace parlour::script
