// Allowances: warnings that the author takes upon himself (language rule 14.2),
// by a comment on the line of the warning or on the line above:
//
//   <!-- check: allow unread-variable -->
//   <!-- check: allow unread-variable, endless-loop -->
//   <!-- check: allow unread-variable in this file -->
//
// A tag of several lines counts as one of them, and so do comments that stand
// one below the other: where lines break does not matter.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "script/source/findings.hpp"

namespace parlour::script {

struct Allowance {
  // The lines that it is for; of a whole file, those of its comment.
  std::uint32_t first = 0;
  std::uint32_t last = 0;
  std::size_t begin = 0; // of the names, in the text
  bool whole_file = false;
  std::vector<std::string> names;
};

std::vector<Allowance> read_allowances(std::string_view text);

// Takes out the warnings that their files allow.
void take_allowed(Findings& findings);

} // namespace parlour::script
