// How findings are printed: lines for people and editors, JSON for programs.
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

FindingCount count(const std::vector<script::Finding>& findings);

// "2 errors, 1 warning".
std::string to_string(const FindingCount& count);

// "file:line:column: severity: message", and below it the line of the file with
// a mark under the place. Files below the working folder are named from there.
void print_lines(std::ostream& out,
                 const std::vector<script::Finding>& findings,
                 const Places& places);

// An array of {file, line, column, end, kind, name, message, fix}; files are
// absolute. `end` is the place behind what is meant, `kind` "error" or
// "warning", `name` that of the lint, or what the error is about. `fix` is an
// array of {begin, end, text}: bytes of the file to replace; empty where no
// correction is safe.
void print_json(std::ostream& out,
                const std::vector<script::Finding>& findings);

} // namespace parlour::tools
