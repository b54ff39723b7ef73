// Braces in a text (language rule 4.4): which of them embed an expression.
//
//   "{1 + 1}"     embeds an expression
//   "{{name}}"    doubled: stands for single braces
//   "{ so on }"   plain: stays as it is
#pragma once

#include <string_view>

#include "script/expression/expression.hpp"

namespace parlour::script {

// An expression in braces.
struct Embedded {
  NodePointer node;    // null: the brace embeds nothing
  std::size_t end = 0; // the offset behind its closing brace
};

// Whether the brace at this offset and the next one stand for a single one.
bool is_doubled(std::string_view text, std::size_t brace);
// The expression that the brace at this offset opens.
Embedded embedded(std::string_view text, std::size_t brace);
// The offset of the first brace that embeds nothing and is not doubled; npos if
// there is none.
std::size_t plain_brace(std::string_view text);

} // namespace parlour::script
