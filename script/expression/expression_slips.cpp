#include "script/expression/expression_slips.hpp"

#include <cctype>

#include "script/expression/slip_rules.hpp"

namespace parlour::script {

namespace slip_rules {

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

} // namespace slip_rules

namespace {

using namespace slip_rules;

constexpr int most_slips = 8; // told of one expression

// The first that knows is right: the particular before the general.
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

ExpressionSlip explain(const Scene& scene) {
  for (const auto rule : rules)
    if (auto slip = rule(scene))
      return *slip;
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

std::vector<ExpressionSlip> find_slips(std::string_view text,
                                       const Parsed& parsed, Wanted wanted,
                                       const IsDeclared& is_declared) {
  std::vector<ExpressionSlip> slips;
  std::string mended(text);
  std::ptrdiff_t longer = 0; // than the text, before the place
  std::string error = parsed.error;
  std::size_t at = parsed.error_offset;
  while (!error.empty() && slips.size() < most_slips) {
    auto slip = explain({mended, at, error, wanted, is_declared});
    const auto place = static_cast<std::ptrdiff_t>(slip.offset) - longer;
    if (place < 0 || (!slips.empty() && place <= static_cast<std::ptrdiff_t>(
                                                     slips.back().offset)))
      break; // before what was mended: it makes no sense any more
    const auto begin = slip.offset;
    slip.offset = static_cast<std::size_t>(place);
    slips.push_back(slip);
    if (!slip.replacement)
      break;
    mended.replace(begin, slip.length, *slip.replacement);
    longer += static_cast<std::ptrdiff_t>(slip.replacement->size()) -
              static_cast<std::ptrdiff_t>(slip.length);
    const auto again = parse_expression(mended);
    error = again.error;
    at = again.error_offset;
    if (mended.substr(at, 1) == ",")
      break; // a list of arguments, which parses as no expression
  }
  // Where not all is mended, nobody knows what was meant.
  if (!error.empty() && !parse_arguments(mended).node)
    for (auto& slip : slips)
      slip.replacement.reset();
  return slips;
}

std::optional<std::string> mended(std::string_view text, Wanted wanted) {
  const auto parsed = parse_expression(text);
  std::string result(text);
  if (parsed.node)
    return result;
  const auto slips = find_slips(text, parsed, wanted);
  for (auto slip = slips.rbegin(); slip != slips.rend(); ++slip) {
    if (!slip->replacement)
      return {};
    result.replace(slip->offset, slip->length, *slip->replacement);
  }
  return parse_expression(result).node ? std::optional(result) : std::nullopt;
}

} // namespace parlour::script
