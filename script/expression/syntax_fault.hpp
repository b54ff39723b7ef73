// SyntaxFault: in which way a text is no expression, as the rules that explain
// mistakes see it.
#pragma once

#include <cstdint>

namespace parlour::script {

enum class SyntaxFault : std::uint8_t {
  none,
  unexpected, // a token that cannot stand here
  missing,    // a sign that has to stand here
  ends_early,
  open_text, // without a closing quote
  escape,    // no or a wrong one behind a backslash
  letters_behind_number,
  other, // the message says it
};

} // namespace parlour::script
