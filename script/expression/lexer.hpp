// Lexer: splits an expression into tokens (language rule 3). It makes tokens on
// demand, as the parser looks only one token ahead.
#pragma once

#include <cstdint>
#include <forward_list>
#include <string>
#include <string_view>

#include "script/expression/syntax_fault.hpp"

namespace parlour::script {

// `end` also follows an error.
enum class TokenKind : std::uint8_t {
  end,
  integer,
  number,
  string,
  word, // a name or a reserved word
  symbol,
};

// The meaning of a symbol or reserved word. `and` and `&&` are the same sign.
// The first ones are the operators, in the order of Operator.
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

// A view into the source where possible. A string with escapes refers to a copy
// that the lexer owns.
struct Token {
  TokenKind kind = TokenKind::end;
  Sign sign = Sign::none;
  std::string_view text; // of a string: its value. Valid as long as the lexer
  std::uint32_t offset = 0;
  std::int64_t integer = 0;
  double number = 0;
};

// Reports at most one error and then only `end` tokens. Not thread-safe.
class Lexer {
public:
  // The text must outlive the lexer.
  explicit Lexer(std::string_view text) : text_(text) {}

  // The next token; `end` at the end of the text and after an error.
  Token next();
  // The message of the error; empty if there is none so far.
  const std::string& error() const {
    return error_;
  }
  std::uint32_t error_offset() const {
    return error_offset_;
  }
  SyntaxFault fault() const {
    return fault_;
  }

private:
  std::uint32_t offset() const {
    return static_cast<std::uint32_t>(at_);
  }
  void fail(std::string message, std::size_t at,
            SyntaxFault fault = SyntaxFault::other);
  // Each reads one kind of token from at_ on and moves behind it.
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
  std::forward_list<std::string> unescaped_; // strings with escapes
  std::string error_;
  std::uint32_t error_offset_ = 0;
  SyntaxFault fault_ = SyntaxFault::none;
};

// The sign of a reserved word; `none` for a name.
Sign sign_of_word(std::string_view word);
// How a symbol is written.
std::string_view spelling_of(Sign sign);

} // namespace parlour::script
