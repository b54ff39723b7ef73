// The tokens of language rule 3: numbers, strings, words and symbols. Text is
// UTF-8; only blanks, digits and symbols of ASCII have a meaning, and every
// other character belongs to a word.

#include "script/expression/lexer.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "runtime/base/text/utf8.hpp"

namespace parlour::script {

namespace {

constexpr auto npos = std::string_view::npos;

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

bool is_ascii(char c) {
  return static_cast<unsigned char>(c) < 0x80;
}

bool starts_word(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' ||
         !is_ascii(c);
}

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

// The offset of a typographic quotation mark in a word; npos if there is none.
// These characters lie beyond ASCII, where every other character counts as a
// letter, so they would become part of a name.
std::size_t find_typographic_quote(std::string_view word) {
  for (std::size_t i = 0; i + 2 < word.size(); ++i)
    if (word[i] == '\xe2' && word[i + 1] == '\x80' &&
        static_cast<unsigned char>(word[i + 2]) >= 0x98 &&
        static_cast<unsigned char>(word[i + 2]) <= 0x9f)
      return i;
  return std::min(word.find("\xc2\xab"), word.find("\xc2\xbb"));
}

struct Spelling {
  std::string_view text;
  Sign sign;
};

// Longer symbols stand before their prefixes.
constexpr std::array symbols{
    Spelling{"==", Sign::equal},      Spelling{"!=", Sign::unequal},
    Spelling{"<=", Sign::less_equal}, Spelling{">=", Sign::greater_equal},
    Spelling{"||", Sign::either},     Spelling{"&&", Sign::both},
    Spelling{"<", Sign::less},        Spelling{">", Sign::greater},
    Spelling{"+", Sign::add},         Spelling{"-", Sign::subtract},
    Spelling{"*", Sign::multiply},    Spelling{"/", Sign::divide},
    Spelling{"%", Sign::modulo},      Spelling{"!", Sign::invert},
    Spelling{"?", Sign::question},    Spelling{":", Sign::colon},
    Spelling{"(", Sign::open_round},  Spelling{")", Sign::close_round},
    Spelling{"[", Sign::open_square}, Spelling{"]", Sign::close_square},
    Spelling{"{", Sign::open_curly},  Spelling{"}", Sign::close_curly},
    Spelling{",", Sign::comma},       Spelling{".", Sign::point}};

constexpr std::array reserved{
    Spelling{"and", Sign::both},         Spelling{"or", Sign::either},
    Spelling{"not", Sign::invert},       Spelling{"eq", Sign::equal},
    Spelling{"ne", Sign::unequal},       Spelling{"lt", Sign::less},
    Spelling{"le", Sign::less_equal},    Spelling{"gt", Sign::greater},
    Spelling{"ge", Sign::greater_equal}, Spelling{"in", Sign::in},
    Spelling{"true", Sign::truth},       Spelling{"false", Sign::falsehood},
    Spelling{"unknown", Sign::unknown}};

} // namespace

Sign sign_of_word(std::string_view word) {
  for (const auto& spelling : reserved)
    if (spelling.text.size() == word.size() && spelling.text[0] == word[0] &&
        spelling.text == word)
      return spelling.sign;
  return Sign::none;
}

// For messages such as "')' is missing".
std::string_view spelling_of(Sign sign) {
  for (const auto& spelling : symbols)
    if (spelling.sign == sign)
      return spelling.text;
  return {};
}

// After an error no token has a meaning, so every further one is `end`.
Token Lexer::next() {
  while (at_ < text_.size() && is_blank(text_[at_]))
    ++at_;
  Token token;
  token.offset = offset();
  if (at_ < text_.size() && error_.empty())
    read(token);
  if (!error_.empty())
    token.kind = TokenKind::end;
  return token;
}

// The first error wins, as next() reads nothing afterwards.
void Lexer::fail(std::string message, std::size_t at, SyntaxFault fault) {
  fault_ = fault;
  error_ = std::move(message);
  error_offset_ = static_cast<std::uint32_t>(at);
}

// The first character decides the kind of token.
void Lexer::read(Token& token) {
  const auto c = text_[at_];
  if (is_digit(c))
    number(token);
  else if (starts_word(c))
    word(token);
  else if (c == '\'' || c == '"')
    string(token, c);
  else
    symbol(token);
}

// A word may hold any characters beyond ASCII: names in any language need no
// tables of Unicode.
void Lexer::word(Token& token) {
  const auto start = at_;
  bool ascii = true;
  for (;
       at_ < text_.size() && (starts_word(text_[at_]) || is_digit(text_[at_]));
       ++at_)
    ascii &= is_ascii(text_[at_]);
  token.kind = TokenKind::word;
  token.text = text_.substr(start, at_ - start);
  token.sign = sign_of_word(token.text);
  // Only a word with characters beyond ASCII can contain one.
  if (const auto quote = ascii ? npos : find_typographic_quote(token.text);
      quote != npos)
    fail("a typographic quotation mark has no meaning here", start + quote);
}

void Lexer::digits() {
  while (at_ < text_.size() && is_digit(text_[at_]))
    ++at_;
}

// An exponent belongs to the number only if digits follow, and so does a point:
// 1.length is an error about a field, not about digits.
void Lexer::number(Token& token) {
  const auto start = at_;
  digits();
  if (at_ + 1 < text_.size() && text_[at_] == '.' && is_digit(text_[at_ + 1])) {
    ++at_;
    digits();
  }
  if (at_ < text_.size() && (text_[at_] | 0x20) == 'e') {
    auto after = at_ + 1;
    if (after < text_.size() && (text_[after] == '+' || text_[after] == '-'))
      ++after;
    if (after < text_.size() && is_digit(text_[after])) {
      at_ = after;
      digits();
    }
  }
  token.text = text_.substr(start, at_ - start);
  if (at_ < text_.size() && starts_word(text_[at_]))
    return fail("a number is followed by letters", at_,
                SyntaxFault::letters_behind_number);
  value(token, start);
}

// Digits that do not fit into 64 bits are read as a number (language rule 2.4).
// The parser relies on this for the smallest integer.
void Lexer::value(Token& token, std::size_t start) {
  const auto* first = token.text.data();
  const auto* last = first + token.text.size();
  auto [end, error] = std::from_chars(first, last, token.integer);
  token.kind = TokenKind::integer;
  if (error == std::errc{} && end == last)
    return;
  token.kind = TokenKind::number;
  auto [stop, wrong] = std::from_chars(first, last, token.number);
  if (wrong != std::errc{} || !std::isfinite(token.number))
    fail("the number is too large", start);
}

// A string without escapes is a view into the source; the first escape switches
// to a copy.
void Lexer::string(Token& token, char quote) {
  const auto start = at_++;
  token.kind = TokenKind::string;
  while (at_ < text_.size() && text_[at_] != quote && text_[at_] != '\\')
    ++at_;
  token.text = text_.substr(start + 1, at_ - start - 1);
  if (at_ < text_.size() && text_[at_] == '\\')
    token.text = with_escapes(token.text, quote);
  if (!error_.empty())
    return;
  if (at_ == text_.size())
    return fail("the string has no closing quote", start,
                SyntaxFault::open_text);
  ++at_;
}

// Continues behind `begun` up to the closing quote or an error.
std::string_view Lexer::with_escapes(std::string_view begun, char quote) {
  auto& value = unescaped_.emplace_front(begun);
  while (at_ < text_.size() && text_[at_] != quote && error_.empty())
    if (text_[at_] == '\\')
      escape(value);
    else
      value += text_[at_++];
  return value;
}

// Language rule 3.1 lists the escapes.
void Lexer::escape(std::string& text) {
  const auto start = at_++;
  const auto c = at_ < text_.size() ? text_[at_++] : '\0';
  switch (c) {
  case '\'':
  case '"':
  case '\\':
    text += c;
    return;
  case 'n':
    text += '\n';
    return;
  case 't':
    text += '\t';
    return;
  case 'r':
    text += '\r';
    return;
  case 'u':
    return unicode(text, start);
  default:
    fail("an escape is one of \\' \\\" \\\\ \\n \\t \\r \\u{…}", start,
         SyntaxFault::escape);
  }
}

// \u{e9}: up to six hexadecimal digits; surrogates are no characters.
void Lexer::unicode(std::string& text, std::size_t start) {
  std::uint32_t code = 0;
  const auto close = text_.find('}', at_);
  if (at_ >= text_.size() || text_[at_] != '{' ||
      close == std::string_view::npos)
    return fail("\\u is followed by hexadecimal digits in braces", start,
                SyntaxFault::escape);
  const auto* first = text_.data() + at_ + 1;
  const auto* last = text_.data() + close;
  auto [end, error] = std::from_chars(first, last, code, 16);
  if (error != std::errc{} || end != last || code > 0x10ffff ||
      (code >= 0xd800 && code < 0xe000))
    return fail("\\u{…} is not a character", start, SyntaxFault::escape);
  append_code_point(text, code);
  at_ = close + 1;
}

// '=' gets a message of its own, because it is the most frequent mistake.
void Lexer::symbol(Token& token) {
  for (const auto& [text, sign] : symbols)
    if (text[0] == text_[at_] && text_.substr(at_).starts_with(text)) {
      token.kind = TokenKind::symbol;
      token.sign = sign;
      token.text = text;
      at_ += text.size();
      return;
    }
  if (text_[at_] == '=')
    return fail("'=' does not compare; write '=='", at_);
  fail(fmt::format("'{}' has no meaning here", text_[at_]), at_);
}

} // namespace parlour::script
