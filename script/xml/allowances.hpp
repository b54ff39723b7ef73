// Allowances: comments by which an author suppresses warnings (language rule
// 14.2), on the line of the warning or the line above:
//
//   <!-- check: allow unread-variable -->
//   <!-- check: allow unread-variable, endless-loop -->
//   <!-- check: allow unread-variable in this file -->
//
// A tag of several lines counts as one line, and so do several comments below
// each other, so line breaks make no difference.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "script/source/findings.hpp"

namespace parlour::script {

struct Allowance {
  // The lines that it covers. With `whole_file`, the lines of the comment
  // itself.
  std::uint32_t first = 0;
  std::uint32_t last = 0;
  std::size_t begin = 0; // offset of the names in the text
  bool whole_file = false;
  std::vector<std::string> names;
};

// All allowances of a file, in order. Fast if there are none.
std::vector<Allowance> read_allowances(std::string_view text);

// Removes the warnings that a comment in their file allows. Errors stay.
void take_allowed(Findings& findings);

} // namespace parlour::script
