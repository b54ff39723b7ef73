#include "tools/parlour/cli/bench_rows.hpp"

#include <algorithm>

namespace parlour::tools {

bool has_row(const std::vector<std::string>& rows, const BenchOptions& options,
             const Console& console) {
  if (options.only.empty() || std::ranges::count(rows, options.only) > 0)
    return true;
  say_error(console,
            "bench " + options.name + " has no row '" + options.only + "'");
  return false;
}

} // namespace parlour::tools
