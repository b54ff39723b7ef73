// Splits an expression into tokens (language rule 3).
#pragma once

#include <cstdint>
#include <forward_list>
#include <string>
#include <string_view>
#include <vector>

namespace parlour::script {

enum class TokenKind : std::uint8_t {
  end,
  integer,
  number,
  string,
  word,   // a name or a reserved word
  symbol, // operators in their canonical spelling: "==", "and" is a word
};

struct Token {
  TokenKind kind = TokenKind::end;
  std::string_view text; // of a string: its value
  std::uint32_t offset = 0;
  std::int64_t integer = 0;
  double number = 0;
};

struct Tokens {
  std::vector<Token> tokens; // ends with `end`; they look into the text
  std::forward_list<std::string> unescaped; // values of strings with escapes
  std::string error;                        // empty: well-formed
  std::uint32_t error_offset = 0;
};

// The text must outlive the tokens.
Tokens tokenize(std::string_view text);

// In UTF-8.
void append_code_point(std::string& text, std::uint32_t code);

} // namespace parlour::script
