// Lexer: an expression's tokens, one after the other (language rule 3).
#pragma once

#include <cstdint>
#include <forward_list>
#include <string>
#include <string_view>

namespace parlour::script {

enum class TokenKind : std::uint8_t {
  end,
  integer,
  number,
  string,
  word, // a name or a reserved word
  symbol,
};

// What a symbol or a reserved word means; the operators as Operator has them.
enum class Sign : std::uint8_t {
  equal,
  unequal,
  less,
  less_equal,
  greater,
  greater_equal,
  in,
  add,
  subtract,
  multiply,
  divide,
  modulo,
  either,
  both,
  invert,
  question,
  colon,
  comma,
  point,
  open_round,
  close_round,
  open_square,
  close_square,
  open_curly,
  close_curly,
  truth,
  falsehood,
  unknown,
  none,
};

struct Token {
  TokenKind kind = TokenKind::end;
  Sign sign = Sign::none;
  std::string_view text; // of a string: its value; lives as long as the lexer
  std::uint32_t offset = 0;
  std::int64_t integer = 0;
  double number = 0;
};

class Lexer {
public:
  // The text must outlive the lexer.
  explicit Lexer(std::string_view text) : text_(text) {}

  // `end` where nothing is left or something is wrong.
  Token next();
  // Empty: well-formed so far.
  const std::string& error() const {
    return error_;
  }
  std::uint32_t error_offset() const {
    return error_offset_;
  }

private:
  std::uint32_t offset() const {
    return static_cast<std::uint32_t>(at_);
  }
  void fail(std::string message, std::size_t at);
  void read(Token& token);
  void word(Token& token);
  void digits();
  void number(Token& token);
  void value(Token& token, std::size_t start);
  void string(Token& token, char quote);
  std::string_view with_escapes(std::string_view begun, char quote);
  void escape(std::string& text);
  void unicode(std::string& text, std::size_t start);
  void symbol(Token& token);

  std::string_view text_;
  std::size_t at_ = 0;
  std::forward_list<std::string> unescaped_; // values of strings with escapes
  std::string error_;
  std::uint32_t error_offset_ = 0;
};

// None where the word is a name.
Sign sign_of_word(std::string_view word);
// Of a symbol.
std::string_view spelling_of(Sign sign);

} // namespace parlour::script
