// What a benchmark measures with: CPU time, so that a busy machine disturbs
// less, and memory as malloc counts it.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace parlour::tools {

// Which rows of a table, and how often each.
struct BenchRows {
  int runs = 5;     // of each; their median counts
  std::string only; // one row; empty: all

  bool wants(const std::string& row) const {
    return only.empty() || only == row;
  }
};

// One run of a workload, ours or a peer's.
struct Measured {
  double nanoseconds = 0; // of CPU time for one operation
  std::string result;     // the same for all who do the same work
};

// CPU time of this process so far.
double cpu_nanoseconds();

// Bytes that malloc has given out, its own overhead included.
std::size_t bytes_in_use();

// 0 of none.
double median(std::vector<double> values);

} // namespace parlour::tools
