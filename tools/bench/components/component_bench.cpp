#include "tools/bench/components/component_bench.hpp"

#include <ostream>

#include <fmt/format.h>

#include "tools/bench/components/component_workload.hpp"
#include "tools/bench/support/contest.hpp"

namespace parlour::tools {

namespace {

constexpr BallGame game{200'000};
// The least share of the throughput of bare actors.
constexpr double bar = 0.70;

} // namespace

std::vector<std::string> component_bench_rows() {
  return {"messages"};
}

bool component_bench(const BenchRows& wanted, std::ostream& out) {
  Series ours;
  Series hub;
  Series direct;
  // The contestants take turns, so that a change of the machine's load affects
  // all of them.
  for (int run = 0; run < wanted.runs; ++run) {
    ours.add(components_play(game));
    hub.add(bare_actors_play(game, Way::hub));
    direct.add(bare_actors_play(game, Way::direct));
  }
  out << fmt::format("CPU time of one operation, median of {} runs\n",
                     wanted.runs);
  if (!ours.trouble.empty()) {
    out << "messages " << ours.trouble << '\n';
    return false;
  }
  const auto figure = median(ours.figures);
  // 1 means as fast as bare actors.
  const auto share = median(hub.figures) / figure;
  out << fmt::format("messages through a component's mailbox {:.0f} ns; bare "
                     "typed actors, through a hub {:.0f} ({:.2f} of their "
                     "speed, bar {:.2f}: {}), from one to the other {:.0f} "
                     "({:.2f})\n",
                     figure, median(hub.figures), share, bar,
                     share >= bar ? "met" : "missed", median(direct.figures),
                     median(direct.figures) / figure);
  return true;
}

} // namespace parlour::tools
