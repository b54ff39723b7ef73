#include "script/lexer.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace parlour::script {

namespace {

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

bool starts_word(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' ||
         static_cast<unsigned char>(c) >= 0x80;
}

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

// They are letters to nobody, but beyond ASCII.
std::size_t find_typographic_quote(std::string_view word) {
  for (std::size_t i = 0; i + 2 < word.size(); ++i)
    if (word[i] == '\xe2' && word[i + 1] == '\x80' &&
        static_cast<unsigned char>(word[i + 2]) >= 0x98 &&
        static_cast<unsigned char>(word[i + 2]) <= 0x9f)
      return i;
  return std::min(word.find("\xc2\xab"), word.find("\xc2\xbb"));
}

// The longest first.
constexpr std::array<std::string_view, 24> symbols{
    "==", "!=", "<=", ">=", "||", "&&", "<", ">", "+", "-", "*", "/",
    "%",  "!",  "?",  ":",  "(",  ")",  "[", "]", "{", "}", ",", "."};

class Lexer {
public:
  explicit Lexer(std::string_view text) : text_(text) {
    result_.tokens.reserve(std::min<std::size_t>(text.size(), 64) / 2 + 2);
  }

  Tokens run() {
    while (result_.error.empty()) {
      while (at_ < text_.size() && is_blank(text_[at_]))
        ++at_;
      Token token;
      token.offset = offset();
      if (at_ == text_.size()) {
        result_.tokens.push_back(token);
        break;
      }
      read(token);
      result_.tokens.push_back(token);
    }
    return std::move(result_);
  }

private:
  std::uint32_t offset() const {
    return static_cast<std::uint32_t>(at_);
  }

  void fail(std::string message, std::size_t at) {
    result_.error = std::move(message);
    result_.error_offset = static_cast<std::uint32_t>(at);
  }

  void read(Token& token) {
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

  void word(Token& token) {
    const auto start = at_;
    while (at_ < text_.size() &&
           (starts_word(text_[at_]) || is_digit(text_[at_])))
      ++at_;
    token.kind = TokenKind::word;
    token.text = text_.substr(start, at_ - start);
    if (const auto quote = find_typographic_quote(token.text);
        quote != std::string::npos)
      fail("a typographic quotation mark has no meaning here", start + quote);
  }

  void digits() {
    while (at_ < text_.size() && is_digit(text_[at_]))
      ++at_;
  }

  void number(Token& token) {
    const auto start = at_;
    digits();
    if (at_ + 1 < text_.size() && text_[at_] == '.' &&
        is_digit(text_[at_ + 1])) {
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
      return fail("a number is followed by letters", at_);
    value(token, start);
  }

  void value(Token& token, std::size_t start) {
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

  void string(Token& token, char quote) {
    const auto start = at_++;
    token.kind = TokenKind::string;
    while (at_ < text_.size() && text_[at_] != quote && text_[at_] != '\\')
      ++at_;
    token.text = text_.substr(start + 1, at_ - start - 1);
    if (at_ < text_.size() && text_[at_] == '\\')
      token.text = with_escapes(token.text, quote);
    if (!result_.error.empty())
      return;
    if (at_ == text_.size())
      return fail("the string has no closing quote", start);
    ++at_;
  }

  // Goes on up to the quote or a fault.
  std::string_view with_escapes(std::string_view begun, char quote) {
    auto& value = result_.unescaped.emplace_front(begun);
    while (at_ < text_.size() && text_[at_] != quote && result_.error.empty())
      if (text_[at_] == '\\')
        escape(value);
      else
        value += text_[at_++];
    return value;
  }

  void escape(std::string& text) {
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
      fail("an escape is one of \\' \\\" \\\\ \\n \\t \\r \\u{…}", start);
    }
  }

  void unicode(std::string& text, std::size_t start) {
    std::uint32_t code = 0;
    const auto close = text_.find('}', at_);
    if (at_ >= text_.size() || text_[at_] != '{' ||
        close == std::string_view::npos)
      return fail("\\u is followed by hexadecimal digits in braces", start);
    const auto* first = text_.data() + at_ + 1;
    const auto* last = text_.data() + close;
    auto [end, error] = std::from_chars(first, last, code, 16);
    if (error != std::errc{} || end != last || code > 0x10ffff ||
        (code >= 0xd800 && code < 0xe000))
      return fail("\\u{…} is not a character", start);
    append_code_point(text, code);
    at_ = close + 1;
  }

  void symbol(Token& token) {
    for (auto candidate : symbols)
      if (candidate[0] == text_[at_] &&
          text_.substr(at_).starts_with(candidate)) {
        token.kind = TokenKind::symbol;
        token.text = candidate;
        at_ += candidate.size();
        return;
      }
    if (text_[at_] == '=')
      return fail("'=' does not compare; write '=='", at_);
    fail(std::string("'") + text_[at_] + "' has no meaning here", at_);
  }

  std::string_view text_;
  std::size_t at_ = 0;
  Tokens result_;
};

} // namespace

void append_code_point(std::string& text, std::uint32_t code) {
  auto put = [&](std::uint32_t byte) { text += static_cast<char>(byte); };
  if (code < 0x80) {
    put(code);
  } else if (code < 0x800) {
    put(0xc0 | code >> 6);
    put(0x80 | (code & 0x3f));
  } else if (code < 0x10000) {
    put(0xe0 | code >> 12);
    put(0x80 | (code >> 6 & 0x3f));
    put(0x80 | (code & 0x3f));
  } else {
    put(0xf0 | code >> 18);
    put(0x80 | (code >> 12 & 0x3f));
    put(0x80 | (code >> 6 & 0x3f));
    put(0x80 | (code & 0x3f));
  }
}

Tokens tokenize(std::string_view text) {
  return Lexer(text).run();
}

} // namespace parlour::script
