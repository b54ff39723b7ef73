#include "tools/bench/speech/process_figures.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <unistd.h>

#include "tools/bench/support/measure.hpp"

namespace parlour::tools {

namespace fs = std::filesystem;

std::vector<int> child_processes() {
  std::vector<int> children;
  for (const auto& thread : fs::directory_iterator("/proc/self/task")) {
    std::ifstream file(thread.path() / "children");
    children.insert(children.end(), std::istream_iterator<int>(file), {});
  }
  return children;
}

// Anonymous memory: what no file holds.
double resident_mebibytes(int process) {
  std::ifstream file("/proc/" + std::to_string(process) + "/status");
  for (std::string name; file >> name;)
    if (double kibibytes = 0; name == "RssAnon:" && file >> kibibytes)
      return kibibytes / 1024;
  return 0;
}

ProcessFigures process_figures() {
  ProcessFigures figures{resident_mebibytes(getpid()), cpu_nanoseconds() / 1e9};
  for (const auto child : child_processes()) {
    figures.mebibytes += resident_mebibytes(child);
    figures.cpu_seconds += cpu_nanoseconds_of(child) / 1e9;
  }
  return figures;
}

} // namespace parlour::tools
