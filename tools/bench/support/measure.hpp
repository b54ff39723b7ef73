// What a benchmark measures with: CPU time, so that a busy machine disturbs
// less, and memory as malloc counts it.
#pragma once

#include <chrono>
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
  double passed = 0;      // by the clock, where that was measured
};

// CPU time of this process so far.
double cpu_nanoseconds();
// Of another one; 0 where there is none.
double cpu_nanoseconds_of(int process);

// CPU time and the clock's, from its making on.
class StopWatch {
public:
  // What a server spends meanwhile counts, too; 0: there is none.
  explicit StopWatch(int server);
  Measured stop(std::size_t operations, std::string result) const;

private:
  int server_;
  double cpu_;
  std::chrono::steady_clock::time_point start_ =
      std::chrono::steady_clock::now();
};

// Bytes that malloc has given out, its own overhead included.
std::size_t bytes_in_use();

// 0 of none.
double median(std::vector<double> values);

} // namespace parlour::tools
