// What benches measure: CPU time, which depends less on how busy the machine is
// than the clock, and memory as malloc counts it.
#pragma once

#include <chrono>
#include <cstddef>
#include <string>
#include <vector>

namespace parlour::tools {

// Which rows of a table are wanted, and how often each is run.
struct BenchRows {
  // The median of the runs counts.
  int runs = 5;
  // The name of one row; empty: all.
  std::string only;
  // Of the table `agents`: how many connect, and how long audio is carried.
  int agents = 1000;
  int seconds = 60;

  bool wants(const std::string& row) const {
    return only.empty() || only == row;
  }
};

// One run of a workload, by us or by a peer.
struct Measured {
  // CPU time of one operation.
  double nanoseconds = 0;
  // The same for all who do the same work, so that contestants can be compared.
  std::string result;
  // Time by the clock for one operation, where it was measured.
  double passed = 0;
};

// CPU time that this process has used, in all its threads.
double cpu_nanoseconds();
// CPU time that another process has used; 0 if there is none.
double cpu_nanoseconds_of(int process);

// Measures CPU time and the clock from its construction on.
//
//  const StopWatch watch(0);
//  for (std::size_t i = 0; i < count; ++i)
//    work(i);
//  return watch.stop(count, result);
class StopWatch {
public:
  // The CPU time of the process `server` is included; 0: there is none.
  explicit StopWatch(int server);
  Measured stop(std::size_t operations, std::string result) const;

private:
  int server_;
  double cpu_;
  std::chrono::steady_clock::time_point start_ =
      std::chrono::steady_clock::now();
};

// The bytes that malloc has given out, its overhead included.
std::size_t bytes_in_use();

// 0 if there are no values.
double median(std::vector<double> values);

} // namespace parlour::tools
