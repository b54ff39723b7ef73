// What is wrong with an expression, said so that its author knows what to
// write instead (language rule 3). Looked for only where the parser gave up.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "script/expression/expression.hpp"

namespace parlour::script {

// What stands where an expression does: what helps depends on it.
enum class Wanted : unsigned char {
  value,
  condition,
  text,   // or a value
  target, // of <set name="…">
};

struct ExpressionSlip {
  std::size_t offset = 0; // bytes of the expression
  std::size_t length = 0; // 0: what stands there
  std::string message;
  // In the place of what was found; nothing where no correction is sure.
  std::optional<std::string> replacement{};
};

// Whether a word is a name that can be used where the expression stands.
using IsDeclared = std::function<bool(const std::string&)>;

// What the parser found, explained; and, where that can be corrected, what it
// finds then, in turn. `parsed` is of `text` and has no node. Without
// `is_declared`, any word may be a name.
std::vector<ExpressionSlip> find_slips(std::string_view text,
                                       const Parsed& parsed,
                                       Wanted wanted = Wanted::value,
                                       const IsDeclared& is_declared = {});

// Whether these are several words and nothing that computes, none of them
// declared.
bool reads_like_text(std::string_view text, const IsDeclared& is_declared);

// The text with all corrections; nothing where these do not make an expression
// of it.
std::optional<std::string> mended(std::string_view text,
                                  Wanted wanted = Wanted::value);

// "'...'" with what must be escaped in it.
std::string quoted_text(std::string_view text);

} // namespace parlour::script
