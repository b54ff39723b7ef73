#include "adapters/nlu/grammar/jsgf_lexer.hpp"

#include <utility>

#include <fmt/format.h>

namespace parlour::adapters::nlu::jsgf {

namespace {

constexpr std::string_view symbols = "()[]|*+=;";

bool is_blank(char letter) {
  return letter == ' ' || letter == '\t' || letter == '\n' || letter == '\r';
}

// Scans the text once, keeping line and column.
class Lexer {
public:
  // A place of 0 means unknown; lines and columns count from 1.
  Lexer(std::string_view text, const SourceLocation& start,
        std::vector<Error>& errors)
      : text_(text), place_(start), errors_(errors) {
    if (place_.line == 0)
      place_.line = 1;
    if (place_.column == 0)
      place_.column = 1;
  }

  std::vector<Lexeme> run() {
    skip_byte_order_mark();
    skip_header();
    while (skip_blanks(), at_ < text_.size())
      take();
    lexemes_.push_back({LexemeKind::end, "", place_});
    return std::move(lexemes_);
  }

private:
  // The character `ahead` bytes further; 0 at the end of the text.
  char letter(std::size_t ahead = 0) const {
    return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0';
  }

  // Columns count bytes.
  void advance() {
    if (text_[at_++] == '\n') {
      ++place_.line;
      place_.column = 1;
    } else {
      ++place_.column;
    }
  }

  // Advances character by character, since lines and columns must be counted.
  void advance_to(std::size_t end) {
    while (at_ < end && at_ < text_.size())
      advance();
  }

  void skip_byte_order_mark() {
    if (text_.starts_with("\xEF\xBB\xBF"))
      at_ = 3;
  }

  // Skips the line that JSGF begins with: "#JSGF V1.0 UTF-8 en;".
  void skip_header() {
    while (is_blank(letter()))
      advance();
    if (text_.substr(at_).starts_with("#JSGF"))
      advance_to(text_.find(';', at_) + 1);
  }

  // Skips blanks and comments, which are those of C++.
  void skip_blanks() {
    while (at_ < text_.size()) {
      if (is_blank(letter()))
        advance();
      else if (letter() == '/' && letter(1) == '/')
        advance_to(text_.find('\n', at_));
      else if (letter() == '/' && letter(1) == '*')
        skip_comment();
      else
        return;
    }
  }

  void skip_comment() {
    const auto end = text_.find("*/", at_ + 2);
    if (end == std::string_view::npos)
      error("a comment that begins here does not end");
    advance_to(end == std::string_view::npos ? text_.size() : end + 2);
  }

  // The first character decides the kind of lexeme.
  void take() {
    const char first = letter();
    if (symbols.find(first) != std::string_view::npos)
      take_symbol();
    else if (first == '<')
      take_enclosed(LexemeKind::rule, '>');
    else if (first == '{')
      take_enclosed(LexemeKind::tag, '}');
    else if (first == '"')
      take_enclosed(LexemeKind::quoted, '"');
    else if (first == '/')
      take_enclosed(LexemeKind::weight, '/');
    else if (first == '@')
      take_reference();
    else
      take_word();
  }

  void take_symbol() {
    const auto place = place_;
    lexemes_.push_back({LexemeKind::symbol, std::string(1, letter()), place});
    advance();
  }

  // Takes a lexeme between `closing` and the current character. <@name> is a
  // reference as well.
  void take_enclosed(LexemeKind kind, char closing) {
    const auto place = place_;
    const auto end = text_.find(closing, at_ + 1);
    if (end == std::string_view::npos) {
      error(fmt::format("'{}' is not followed by '{}'", letter(), closing));
      advance_to(text_.size());
      return;
    }
    std::string inside(text_.substr(at_ + 1, end - at_ - 1));
    advance_to(end + 1);
    if (kind == LexemeKind::rule && inside.starts_with('@'))
      lexemes_.push_back({LexemeKind::reference, inside.substr(1), place});
    else
      lexemes_.push_back({kind, std::move(inside), place});
  }

  // A word ends at a blank or at a character with another meaning.
  bool in_word() const {
    return at_ < text_.size() && !is_blank(letter()) &&
           std::string_view("()[]|*+=;<>{}\"/@").find(letter()) ==
               std::string_view::npos;
  }

  // The longest run of characters that have no other meaning.
  std::string take_while_word() {
    std::string word;
    while (in_word()) {
      word += letter();
      advance();
    }
    return word;
  }

  void take_reference() {
    const auto place = place_;
    advance();
    lexemes_.push_back({LexemeKind::reference, take_while_word(), place});
  }

  void take_word() {
    const auto place = place_;
    auto word = take_while_word();
    // A character that begins nothing, such as "}" or ">", is skipped after the
    // error.
    if (word.empty()) {
      error(fmt::format("'{}' is not expected here", letter()));
      advance();
      return;
    }
    lexemes_.push_back({LexemeKind::word, std::move(word), place});
  }

  void error(std::string message) {
    errors_.push_back({ErrorKind::compile, std::move(message), place_});
  }

  std::string_view text_;
  std::size_t at_ = 0;
  SourceLocation place_;
  std::vector<Error>& errors_;
  std::vector<Lexeme> lexemes_;
};

} // namespace

std::vector<Lexeme> scan(std::string_view text, const SourceLocation& start,
                         std::vector<Error>& errors) {
  return Lexer(text, start, errors).run();
}

} // namespace parlour::adapters::nlu::jsgf
