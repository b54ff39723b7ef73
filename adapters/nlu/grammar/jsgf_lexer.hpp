// The lexer of JSGF: splits a grammar into lexemes with their places.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "runtime/base/error.hpp"

namespace parlour::adapters::nlu::jsgf {

enum class LexemeKind {
  word,
  quoted,
  rule,      // text without < >
  reference, // text without @
  tag,       // text without { }
  weight,    // text without / /
  symbol,    // one of ( ) [ ] | * + = ;
  end,
};

// A word, name or sign of the grammar, without the brackets around it.
struct Lexeme {
  LexemeKind kind = LexemeKind::end;
  std::string text;
  SourceLocation place;

  // Whether this is the symbol.
  bool is(char symbol) const {
    return kind == LexemeKind::symbol && text[0] == symbol;
  }
};

// `start` is the place of the first character in the file. Errors are added to
// `errors`. The last lexeme is always `end`.
std::vector<Lexeme> scan(std::string_view text, const SourceLocation& start,
                         std::vector<Error>& errors);

} // namespace parlour::adapters::nlu::jsgf
