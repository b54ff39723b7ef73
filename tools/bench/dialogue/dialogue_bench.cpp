#include "tools/bench/dialogue/dialogue_bench.hpp"

#include <filesystem>
#include <ostream>

#include <fmt/format.h>

#include "tools/bench/dialogue/dialogue_workload.hpp"
#include "tools/bench/support/contest.hpp"

namespace parlour::tools {

namespace {

namespace fs = std::filesystem;

const fs::path workloads = PARLOUR_WORKLOADS;

struct Row {
  const char* name;
  const char* sentence;
  // The largest time of one operation, in nanoseconds.
  double bar;
  // The largest share of Lua 5.4's time; 0: no bar.
  double of_lua;
  Expected<Measured> (DialogueWorkload::*run)(int count) const;
  int count;
};

// The number of events is chosen so that both sides end in the same state.
const Row rows[] = {
    {"turns", "a turn of the user, in acts", 500, 0.80,
     &DialogueWorkload::turns, 20'000},
    {"events", "an event, guarded, that counts", 100, 0,
     &DialogueWorkload::events, 200'002},
};

// Prints one row. False if it could not be measured.
bool measure(const Row& row, int runs, std::ostream& out) {
  const auto workload =
      DialogueWorkload::load(workloads / fmt::format("{}.xml", row.name));
  if (!workload) {
    out << fmt::format("{:<8} {}\n", row.name, workload.error().message);
    return false;
  }
  const LuaContest contest(
      runs, [&] { return ((*workload).*row.run)(row.count); },
      workloads / fmt::format("{}.lua", row.name));
  // The median of CPU time, compared with an absolute bar; the ratio to Lua
  // follows.
  const auto figure = median(contest.ours.figures);
  out << fmt::format("{:<8} {:<31} {:6.0f} ns, bar {:.0f}: {}", row.name,
                     row.sentence, figure, row.bar,
                     figure <= row.bar ? "met" : "missed");
  const auto& trouble = contest.ours.trouble;
  if (!trouble.empty())
    out << "; " << trouble;
  const bool ok = contest.compare(row.of_lua, out);
  out << std::endl;
  return ok && trouble.empty();
}

} // namespace

std::vector<std::string> dialogue_bench_rows() {
  std::vector<std::string> names;
  for (const auto& row : rows)
    names.emplace_back(row.name);
  return names;
}

bool dialogue_bench(const BenchRows& wanted, std::ostream& out) {
  out << fmt::format("CPU time of one operation, median of {} runs\n",
                     wanted.runs);
  bool ok = true;
  for (const auto& row : rows)
    if (wanted.wants(row.name))
      ok &= measure(row, wanted.runs, out);
  return ok;
}

} // namespace parlour::tools
