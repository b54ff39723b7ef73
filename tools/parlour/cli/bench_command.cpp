#include <algorithm>

#include "tools/bench/benches.hpp"
#include "tools/parlour/cli/bench_rows.hpp"
#include "tools/parlour/cli/commands.hpp"
#include "tools/parlour/console/console.hpp"
#include "tools/parlour/console/exit_code.hpp"

namespace parlour::tools {

// The command line has looked whether there is such a bench.
int bench_command(const BenchOptions& options, const Console& console) {
  const auto& bench =
      *std::find_if(benches().begin(), benches().end(),
                    [&](const Bench& one) { return one.name == options.name; });
  if (!has_row(bench.rows, options, console))
    return exit_code::usage;
  return bench.run({options.runs, options.only}, console.out)
             ? exit_code::well
             : exit_code::wrong;
}

} // namespace parlour::tools
