#include "tools/bench/benches.hpp"

#include "tools/bench/agents/agent_bench.hpp"
#include "tools/bench/components/component_bench.hpp"
#include "tools/bench/database/db_bench.hpp"
#include "tools/bench/dialogue/dialogue_bench.hpp"
#include "tools/bench/script/script_bench.hpp"

namespace parlour::tools {

const std::vector<Bench>& benches() {
  static const std::vector<Bench> all = {
      {"script", script_bench_rows(), script_bench},
      {"dialogue", dialogue_bench_rows(), dialogue_bench},
      {"db", db_bench_rows(), db_bench},
      {"components", component_bench_rows(), component_bench},
      {"agents", agent_bench_rows(), agent_bench},
  };
  return all;
}

} // namespace parlour::tools
