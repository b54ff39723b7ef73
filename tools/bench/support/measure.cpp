#include "tools/bench/support/measure.hpp"

#include <algorithm>
#include <ctime>
#include <utility>

#include <malloc.h>

namespace parlour::tools {

namespace {

double nanoseconds(clockid_t clock) {
  timespec time{};
  clock_gettime(clock, &time);
  return static_cast<double>(time.tv_sec) * 1e9 +
         static_cast<double>(time.tv_nsec);
}

} // namespace

double cpu_nanoseconds() {
  return nanoseconds(CLOCK_PROCESS_CPUTIME_ID);
}

// The clock of another process can be read by its owner.
double cpu_nanoseconds_of(int process) {
  clockid_t clock{};
  return process > 0 && clock_getcpuclockid(process, &clock) == 0
             ? nanoseconds(clock)
             : 0;
}

StopWatch::StopWatch(int server)
    : server_(server), cpu_(cpu_nanoseconds() + cpu_nanoseconds_of(server)) {}

Measured StopWatch::stop(std::size_t operations, std::string result) const {
  const std::chrono::duration<double, std::nano> passed =
      std::chrono::steady_clock::now() - start_;
  const auto spent = cpu_nanoseconds() + cpu_nanoseconds_of(server_) - cpu_;
  const auto count = static_cast<double>(operations);
  return {spent / count, std::move(result), passed.count() / count};
}

std::size_t bytes_in_use() {
  const auto info = mallinfo2();
  // Blocks on the heap, and those that malloc has mapped by themselves.
  return info.uordblks + info.hblkhd;
}

double median(std::vector<double> values) {
  if (values.empty())
    return 0;
  const auto middle =
      values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  // Linear time; of an even number of values the upper middle one.
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

} // namespace parlour::tools
