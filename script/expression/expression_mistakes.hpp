// Explains what is wrong with an expression and, if possible, how to write it
// (language rule 3). It runs only after the parser has given up, so it may be
// slow and thorough; correct expressions pay nothing.
//
// An example: for `name = 'Ann'` in a condition the parser says that '=' does
// not compare. The rules make of it "write '=='" with a correction at the right
// place; in <set expr="…"> they explain that the value stands alone.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "script/expression/expression.hpp"

namespace parlour::script {

// What is expected in the attribute. The advice depends on it: "a = 1" is a
// comparison in a condition and an assignment elsewhere.
enum class Wanted : unsigned char {
  value,
  condition,
  text,   // a text or a value
  target, // the name in <set name="…">
};

// One mistake, in offsets of the original text.
struct ExpressionMistake {
  std::size_t offset = 0; // bytes of the expression
  std::size_t length = 0; // 0: the word that stands there
  std::string message;
  // Replaces [offset, offset + length); nothing if no correction is certain.
  std::optional<std::string> replacement{};
};

// Whether a name can be used where the expression stands.
using IsDeclared = std::function<bool(const std::string&)>;

// All mistakes that can be told apart. The first explains the parser's error.
// If it has a correction, the corrected text is parsed again and the next error
// is explained, up to a limit. `parsed` must be the result for `text`, without
// a node. Without `is_declared` any word may be a name.
std::vector<ExpressionMistake>
find_mistakes(std::string_view text, const Parsed& parsed,
              Wanted wanted = Wanted::value,
              const IsDeclared& is_declared = {});

// Whether the text consists of several words, with no operator among them and
// none of them declared: probably a text without its quotes.
bool reads_like_text(std::string_view text, const IsDeclared& is_declared);

// The text with all corrections applied; nothing if that does not make it an
// expression.
std::optional<std::string> mended(std::string_view text,
                                  Wanted wanted = Wanted::value);

// The text as a string literal: in single quotes, with escapes.
std::string quoted_text(std::string_view text);

} // namespace parlour::script
