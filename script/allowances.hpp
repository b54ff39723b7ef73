// Allowances: warnings that the author takes upon himself (language rule 14.2),
// by a comment on the line of the warning or on the line above:
//
//   <!-- check: allow unread-variable -->
//   <!-- check: allow unread-variable, endless-loop -->
//   <!-- check: allow unread-variable in this file -->
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "script/findings.hpp"

namespace parlour::script {

struct Allowance {
  std::uint32_t line = 0; // where its comment ends
  std::size_t begin = 0;  // of the names, in the text
  bool alone = false;     // nothing else stands on its line
  bool whole_file = false;
  std::vector<std::string> names;
};

std::vector<Allowance> read_allowances(std::string_view text);

// Takes out the warnings that their files allow.
void take_allowed(Findings& findings);

} // namespace parlour::script
