// Workloads are pairs of files in tools/bench/workloads: NAME.xml in the script
// language and NAME.lua for the peers. A row counts only if both give the same
// result.
#include "tools/bench/script/script_bench.hpp"

#include <filesystem>
#include <fstream>
#include <ostream>
#include <sstream>

#include <fmt/format.h>
#include <unistd.h>

#include "tools/bench/script/load_bench.hpp"
#include "tools/bench/script/script_workload.hpp"
#include "tools/bench/script/state_bench.hpp"
#include "tools/bench/support/contest.hpp"

namespace parlour::tools {

namespace {

namespace fs = std::filesystem;

// The build says where the files are.
const fs::path workloads = PARLOUR_WORKLOADS;

// A workload that exists in Lua, too. `bar` is the largest share of Lua 5.4's
// time.
struct Contest {
  const char* name;
  const char* sentence;
  double bar;
};

constexpr Contest contests[] = {
    {"calls", "a function call (fib 30)", 0.60},
    {"loop", "an iteration with integers", 0.90},
    {"strings", "join, part, replace", 0.45},
    {"lists", "append, index, sort", 0.40},
    {"maps", "read and write an entry", 0.50},
    {"dispatch", "if and else over 8 texts", 0.70},
    {"suspend", "suspend and resume", 0.15},
    {"builtin", "call of a built-in", 0.45},
};

// The size of the script that is loaded.
constexpr std::size_t load_bytes = 100'000;

class ScriptBench {
public:
  ScriptBench(const BenchRows& wanted, std::ostream& out)
      : wanted_(wanted), out_(out) {}

  bool run();

private:
  // One function for each kind of row.
  void contest(const Contest& contest);
  void switches();
  void suspended();
  void state();
  void load();
  void fail(const std::string& name, const std::string& message);
  Series measure(const std::string& name);

  const BenchRows& wanted_;
  std::ostream& out_;
  bool well_ = true;
};

void ScriptBench::fail(const std::string& name, const std::string& message) {
  out_ << fmt::format("{:<10} {}\n", name, message);
  well_ = false;
}

// Prints a row in which Lua competes.
void ScriptBench::contest(const Contest& contest) {
  const auto file = workloads / contest.name;
  const auto workload =
      ScriptWorkload::load(fs::path(file).replace_extension(".xml"));
  if (!workload)
    return fail(contest.name, workload.error().message);
  // Each run of ours is followed by a run of each Lua.
  const LuaContest held(
      wanted_.runs, [&] { return workload->run(); },
      fs::path(file).replace_extension(".lua"));
  if (!held.ours.trouble.empty())
    return fail(contest.name, held.ours.trouble);
  out_ << fmt::format("{:<10} {:<28} {:6.1f} ns", contest.name,
                      contest.sentence, median(held.ours.figures));
  well_ &= held.compare(contest.bar, out_);
  out_ << std::endl;
}

// Runs a workload that has no peer.
Series ScriptBench::measure(const std::string& name) {
  Series series;
  const auto workload = ScriptWorkload::load(workloads / name);
  if (!workload)
    series.trouble = workload.error().message;
  for (int run = 0; run < wanted_.runs && workload; ++run)
    series.add(workload->run());
  return series;
}

// A switch must not become slower with the number of its arms.
void ScriptBench::switches() {
  const auto few = measure("switch_8.xml");
  const auto many = measure("switch_64.xml");
  if (!few.trouble.empty() || !many.trouble.empty())
    return fail("switch", few.trouble + many.trouble);
  const auto of_8 = median(few.figures);
  const auto of_64 = median(many.figures);
  out_ << fmt::format("{:<10} {:<28} {:6.1f} ns; of 8 arms {:.1f} ({})\n",
                      "switch", "of 64 arms", of_64, of_8,
                      verdict(of_64 / of_8, 1.5));
}

// The memory of an activation that waits, compared with a coroutine of Lua.
void ScriptBench::suspended() {
  constexpr double bar = 200;
  const auto workload = ScriptWorkload::load(workloads / "suspended.xml");
  const auto bytes = workload ? workload->suspended_bytes()
                              : tl::make_unexpected(workload.error());
  if (!bytes)
    return fail("suspended", bytes.error().message);
  out_ << fmt::format("{:<10} {:<28} {:6.0f} B ; bar {:.0f}: {}", "suspended",
                      "bytes of an activation", *bytes, bar,
                      *bytes <= bar ? "met" : "missed");
  // For memory the peers' result is the number of bytes.
  for (const auto& peer : lua_peers())
    if (peer.is_there())
      if (const auto theirs = peer.run(workloads / "suspended.lua"))
        out_ << "; " << peer.title << " " << theirs->result;
  out_ << std::endl;
}

// Saving and restoring a session; short, so it is repeated more often.
void ScriptBench::state() {
  std::vector<double> save;
  std::vector<double> restore;
  std::size_t bytes = 0;
  for (int run = 0; run < wanted_.runs * 10; ++run) {
    const auto times = state_once(workloads / "state.xml");
    if (!times)
      return fail("state", times.error().message);
    save.push_back(times->save);
    restore.push_back(times->restore);
    bytes = times->bytes;
  }
  out_ << fmt::format("{:<10} {:<28} {:6.1f} us; back {:.1f} us\n", "state",
                      fmt::format("of a session, {} bytes", bytes),
                      median(save) / 1e3, median(restore) / 1e3);
}

// Writes a script of 100 KB to a temporary file and loads it again and again.
void ScriptBench::load() {
  std::ifstream pattern(workloads / "load.xml");
  std::ostringstream text;
  text << pattern.rdbuf();
  const auto file =
      fs::temp_directory_path() / fmt::format("parlour-bench-{}.xml", getpid());
  std::ofstream(file) << repeated_script(text.str(), load_bytes);
  std::vector<double> ours;
  std::vector<double> theirs;
  std::string trouble;
  for (int run = 0; run < wanted_.runs * 10 && trouble.empty(); ++run) {
    const auto times = load_once(file);
    if (!times) {
      trouble = times.error().message;
      break;
    }
    ours.push_back(times->ours);
    theirs.push_back(times->parse_and_walk);
  }
  fs::remove(file);
  if (!trouble.empty())
    return fail("load", trouble);
  out_ << fmt::format("{:<10} {:<28} {:6.2f} ms; pugixml, parse and walk only "
                      "{:.2f} ({}); bar 2 ms: {}\n",
                      "load", "a script of 100 KB", median(ours) / 1e6,
                      median(theirs) / 1e6,
                      verdict(median(ours) / median(theirs), 2),
                      median(ours) < 2e6 ? "met" : "missed");
}

bool ScriptBench::run() {
  out_ << fmt::format("CPU time of one operation, median of {} runs\n",
                      wanted_.runs);
  for (const auto& each : contests)
    if (wanted_.wants(each.name))
      contest(each);
  if (wanted_.wants("switch"))
    switches();
  if (wanted_.wants("suspended"))
    suspended();
  if (wanted_.wants("state"))
    state();
  if (wanted_.wants("load"))
    load();
  return well_;
}

} // namespace

std::vector<std::string> script_bench_rows() {
  std::vector<std::string> names;
  for (const auto& each : contests)
    names.emplace_back(each.name);
  names.insert(names.end(), {"switch", "suspended", "state", "load"});
  return names;
}

bool script_bench(const BenchRows& wanted, std::ostream& out) {
  return ScriptBench(wanted, out).run();
}

} // namespace parlour::tools
