#include "tools/bench/script_bench.hpp"
#include "tools/parlour/commands.hpp"
#include "tools/parlour/exit_code.hpp"

namespace parlour::tools {

int bench_command(const BenchOptions& options, const Console& console) {
  const auto well = script_bench({options.runs, options.only}, console.out);
  return well ? exit_code::well : exit_code::wrong;
}

} // namespace parlour::tools
