// Compares our runs of a workload with those of a peer, and prints what a row
// of a table says about them. Both sides must give the same result, or there is
// no comparison.
#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

#include "tools/bench/support/lua_peer.hpp"
#include "tools/bench/support/measure.hpp"

namespace parlour::tools {

// All runs of one workload by one contestant. The median counts.
struct Series {
  std::vector<double> figures;
  // By the clock.
  std::vector<double> passed;
  std::string result;
  // Why a run failed; empty if none did.
  std::string trouble;

  void add(const Expected<Measured>& measured);
};

// "0.57, bar 0.60: met". A smaller ratio is better.
std::string verdict(double ratio, double bar);

// Prints "; Lua 5.4 26.3 (0.66, bar 0.60: missed)", or why there is no figure.
// False if the peer ran but its result differs. A bar of 0 means none.
bool compare(const Series& ours, const Series& theirs, const LuaPeer& peer,
             double bar, std::ostream& out);

// One workload, run by us and by every Lua that is installed, in turn.
struct LuaContest {
  Series ours;
  // One for each of lua_peers().
  std::vector<Series> theirs;

  LuaContest(int runs, const std::function<Expected<Measured>()>& run,
             const std::filesystem::path& lua);
  // Prints the comparison with all of them; the bar is for the first.
  bool compare(double bar, std::ostream& out) const;
};

} // namespace parlour::tools
