// What is wrong with an expression, said so that its author knows what to
// write instead (language rule 3). Looked for only where the parser gave up.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "script/expression.hpp"

namespace parlour::script {

struct ExpressionSlip {
  std::size_t offset = 0; // bytes of the expression
  std::size_t length = 0; // 0: what stands there
  std::string message;
  // In the place of what was found; nothing where no correction is sure.
  std::optional<std::string> replacement{};
};

// What the parser found, explained; and, where that can be corrected, what it
// finds then, in turn. `parsed` is of `text` and has no node.
std::vector<ExpressionSlip> find_slips(std::string_view text,
                                       const Parsed& parsed);

// "'...'" with what must be escaped in it.
std::string quoted_text(std::string_view text);

} // namespace parlour::script
