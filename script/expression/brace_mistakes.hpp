// Explains braces in a text that embed nothing although they look as if they
// were meant to (language rules 4.4 and 14.3): "Hello {name" or "{count + }".
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "script/expression/expression_mistakes.hpp"

namespace parlour::script {

// Which names exist where the text stands.
struct KnownNames {
  IsDeclared variable; // besides the built-in ones
  IsDeclared function; // besides the built-in ones
};

// What is wrong with one pair of braces.
struct BraceMistake {
  std::size_t length = 0; // bytes, both braces included; 1: not closed
  std::string message;    // what to write instead
  // Replaces the braces and what they hold; nothing if no correction is
  // certain.
  std::optional<std::string> replacement{};
};

// Explains the brace at `at`, which must neither embed an expression nor be
// doubled. Returns nothing if the braces are probably meant as text: they hold
// plain words, or nothing in them is a known name. `is_heard` says that
// somebody will hear or read the text; less is then taken for plain text.
std::optional<BraceMistake> explain_brace(std::string_view text, std::size_t at,
                                          const KnownNames& known,
                                          bool is_heard);

} // namespace parlour::script
