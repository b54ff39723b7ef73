// Our runs of one workload beside a peer's of the same: what a table's row
// tells of them.
#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

#include "tools/bench/support/lua_peer.hpp"
#include "tools/bench/support/measure.hpp"

namespace parlour::tools {

// All runs of one workload by one who does it; the median counts.
struct Series {
  std::vector<double> figures;
  std::vector<double> passed; // by the clock
  std::string result;
  std::string trouble; // empty: all well

  void add(const Expected<Measured>& measured);
};

// "0.57, bar 0.60: met"; a smaller ratio is a better one.
std::string verdict(double ratio, double bar);

// "; Lua 5.4 26.3 (0.66, bar 0.60: missed)", or why there is no figure. False
// where the peer is there but gave another result. No bar: 0.
bool compare(const Series& ours, const Series& theirs, const LuaPeer& peer,
             double bar, std::ostream& out);

// One workload by us and by every Lua that is there, in turn.
struct LuaContest {
  Series ours;
  std::vector<Series> theirs; // of each of lua_peers()

  LuaContest(int runs, const std::function<Expected<Measured>()>& run,
             const std::filesystem::path& lua);
  // Of all of them; the bar is of the first.
  bool compare(double bar, std::ostream& out) const;
};

} // namespace parlour::tools
