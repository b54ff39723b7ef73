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

namespace {

// The reader takes a backslash away from any character.
std::string quoted_text(std::string_view text) {
  std::string quoted = "\"";
  for (const char each : text) {
    if (each == '"' || each == '\\')
      quoted += '\\';
    quoted += each;
  }
  return quoted + '"';
}

// 10 is the same as '10', and yet another value.
bool are_alike(const Value& one, const Value& other) {
  return one.type() == other.type() && one == other;
}

bool is_one_word(std::string_view text) {
  return !text.empty() && text.front() != '\'' && text.front() != '"' &&
         text.find_first_of(" \t\r\n") == std::string_view::npos;
}

} // namespace

std::optional<std::string> written(const Value& value) {
  if (value.if_list() || value.if_map() || value.if_result())
    return std::nullopt;
  auto text = to_string(value);
  if (is_one_word(text) && are_alike(Word{text, false}.value(), value))
    return text;
  return value.if_string() ? std::optional(quoted_text(text)) : std::nullopt;
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
