// Words, quotes and " = " of one line.
#include "tools/parlour/conversation_test/directive_reader.hpp"

namespace parlour::tools {

namespace {

constexpr std::string_view blanks = " \t\r";
constexpr std::string_view equals = " = ";

// Splits at `place`, where " = " begins; nothing for npos.
std::optional<Sides> split_at(std::string_view text, std::size_t place) {
  if (place == std::string_view::npos)
    return std::nullopt;
  return Sides{trimmed(text.substr(0, place)),
               trimmed(text.substr(place + equals.size()))};
}

} // namespace

Value Word::value() const {
  if (quoted)
    return text;
  if (text == "unknown")
    return {};
  if (text == "true" || text == "false")
    return text == "true";
  // A number that would print differently is text (language rule 4.3): 007 is
  // part of a telephone number.
  if (auto number = parse_number(text); to_string(number) == text)
    return number;
  return text;
}

DirectiveReader::DirectiveReader(std::string_view text)
    : rest_(trimmed(text)) {}

// `rest_` never begins or ends with blanks.
std::optional<Word> DirectiveReader::word() {
  if (rest_.empty())
    return std::nullopt;
  if (rest_.front() == '\'' || rest_.front() == '"')
    return quoted_word(rest_.front());
  const auto word = rest_.substr(0, rest_.find_first_of(blanks));
  rest_ = trimmed(rest_.substr(word.size()));
  return Word{std::string(word), false};
}

// A backslash escapes the next character, such as the quote.
std::optional<Word> DirectiveReader::quoted_word(char quote) {
  Word word{{}, true};
  for (std::size_t i = 1; i < rest_.size(); ++i) {
    if (rest_[i] == quote) {
      rest_ = trimmed(rest_.substr(i + 1));
      return word;
    }
    if (rest_[i] == '\\' && i + 1 < rest_.size())
      ++i;
    word.text += rest_[i];
  }
  open_quote_ = true;
  return std::nullopt;
}

std::string_view trimmed(std::string_view text) {
  const auto from = text.find_first_not_of(blanks);
  if (from == std::string_view::npos)
    return {};
  return text.substr(from, text.find_last_not_of(blanks) - from + 1);
}

std::optional<Sides> split_at_first_equals(std::string_view text) {
  return split_at(text, text.find(equals));
}

std::optional<Sides> split_at_last_equals(std::string_view text) {
  return split_at(text, text.rfind(equals));
}

} // namespace parlour::tools
