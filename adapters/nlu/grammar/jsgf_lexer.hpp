// Lexemes of JSGF with their places.
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

struct Lexeme {
  LexemeKind kind = LexemeKind::end;
  std::string text;
  Place place;

  bool is(char symbol) const {
    return kind == LexemeKind::symbol && text[0] == symbol;
  }
};

// `start` is the place of the text's first character. The last lexeme is
// `end`.
std::vector<Lexeme> scan(std::string_view text, const Place& start,
                         std::vector<Error>& errors);

} // namespace parlour::adapters::nlu::jsgf
