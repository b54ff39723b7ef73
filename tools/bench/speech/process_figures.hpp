// Memory and CPU time of this process and of its children: a recogniser may be
// a program of its own.
#pragma once

#include <vector>

namespace parlour::tools {

// Those that this process has started and that still run.
std::vector<int> child_processes();
// Resident, in MiB, without what is shared with files; 0 if there is no such
// process.
double resident_mebibytes(int process);

struct ProcessFigures {
  double mebibytes = 0;
  double cpu_seconds = 0;
};

// Of this process and its children together, since each began.
ProcessFigures process_figures();

} // namespace parlour::tools
