#include <algorithm>

#include "tools/bench/dialogue_bench.hpp"
#include "tools/bench/script_bench.hpp"
#include "tools/parlour/commands.hpp"
#include "tools/parlour/console.hpp"
#include "tools/parlour/exit_code.hpp"

namespace parlour::tools {

int bench_command(const BenchOptions& options, const Console& console) {
  const bool dialogue = options.name == "dialogue";
  const auto rows = dialogue ? dialogue_bench_rows() : script_bench_rows();
  if (!options.only.empty() &&
      std::find(rows.begin(), rows.end(), options.only) == rows.end()) {
    say_error(console,
              "bench " + options.name + " has no row '" + options.only + "'");
    return exit_code::usage;
  }
  const bool well =
      dialogue ? dialogue_bench({options.runs, options.only}, console.out)
               : script_bench({options.runs, options.only}, console.out);
  return well ? exit_code::well : exit_code::wrong;
}

} // namespace parlour::tools
