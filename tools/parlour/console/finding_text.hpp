// Prints the findings of the compiler and of `check` (script/source): as lines
// for people and editors, or as JSON for programs.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "script/source/findings.hpp"
#include "tools/parlour/console/places.hpp"

namespace parlour::tools {

struct FindingCount {
  std::size_t errors = 0;
  std::size_t warnings = 0;
};

// Counts errors and warnings.
FindingCount count(const std::vector<script::Finding>& findings);

// "2 errors, 1 warning".
std::string to_string(const FindingCount& count);

// Prints "file:line:column: severity: message" for each finding, and below it
// the source line with a mark under the place. Files below the working folder
// are shown relative to it. Reads the files again to show their lines.
void print_lines(std::ostream& out,
                 const std::vector<script::Finding>& findings,
                 const Places& places);

// Prints an array of {file, line, column, end, kind, name, message, fix}.
//
// `file` is absolute; lines and columns count from 1. `end` is the place behind
// the marked text. `kind` is "error" or "warning". `name` is the lint's name,
// or what an error is about. `fix` is an array of {begin, end, text}, which are
// bytes of the file and their replacement; it is empty if no correction is
// safe.
void print_json(std::ostream& out,
                const std::vector<script::Finding>& findings);

} // namespace parlour::tools
