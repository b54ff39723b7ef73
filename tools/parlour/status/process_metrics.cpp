#include "tools/parlour/status/process_metrics.hpp"

#include <fstream>
#include <string>

#include <sys/resource.h>
#include <unistd.h>

namespace parlour::tools {

namespace {

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) +
         static_cast<double>(time.tv_usec) / 1e6;
}

double cpu_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

// The second number is what is in memory, in pages.
double resident_bytes() {
  std::ifstream file("/proc/self/statm");
  double all = 0;
  double resident = 0;
  file >> all >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE));
}

double threads() {
  std::ifstream file("/proc/self/status");
  std::string word;
  double count = 0;
  while (file >> word)
    if (word == "Threads:")
      file >> count;
  return count;
}

} // namespace

Metrics process_metrics() {
  using enum MetricKind;
  return {metric("process_resident_memory_bytes", gauge,
                 "Memory that is in use and not swapped out.",
                 resident_bytes()),
          metric("process_cpu_seconds_total", counter,
                 "Time of processors, of user and system.", cpu_seconds()),
          metric("process_threads", gauge, "Threads.", threads())};
}

} // namespace parlour::tools
