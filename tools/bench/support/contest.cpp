#include "tools/bench/support/contest.hpp"

#include <ostream>

#include <fmt/format.h>

namespace parlour::tools {

void Series::add(const Expected<Measured>& measured) {
  if (!measured) {
    trouble = measured.error().message;
    return;
  }
  figures.push_back(measured->nanoseconds);
  passed.push_back(measured->passed);
  result = measured->result;
}

std::string verdict(double ratio, double bar) {
  return fmt::format("{:.2f}, bar {:.2f}: {}", ratio, bar,
                     ratio <= bar ? "met" : "missed");
}

// A missing peer is no failure; a different result is.
bool compare(const Series& ours, const Series& theirs, const LuaPeer& peer,
             double bar, std::ostream& out) {
  if (!peer.is_there()) {
    out << fmt::format("; {}: {} is not built: tools/dependencies bench "
                       "({}), then tools/bench/run",
                       peer.title, peer.program, peer.package);
    return true;
  }
  if (!theirs.trouble.empty() || ours.result != theirs.result) {
    out << fmt::format("; {}: no comparison, {}", peer.title,
                       theirs.trouble.empty()
                           ? "its result is " + theirs.result + ", not " +
                                 ours.result
                           : theirs.trouble);
    return false;
  }
  const auto figure = median(theirs.figures);
  const auto ratio = median(ours.figures) / figure;
  out << fmt::format("; {} {:.1f} ({})", peer.title, figure,
                     bar > 0 ? verdict(ratio, bar)
                             : fmt::format("{:.2f}", ratio));
  return true;
}

LuaContest::LuaContest(int runs, const std::function<Expected<Measured>()>& run,
                       const std::filesystem::path& lua)
    : theirs(lua_peers().size()) {
  // Contestants take turns, so that a change of the machine's load affects all
  // of them.
  for (int i = 0; i < runs; ++i) {
    ours.add(run());
    for (std::size_t peer = 0; peer < theirs.size(); ++peer)
      if (lua_peers()[peer].is_there())
        theirs[peer].add(lua_peers()[peer].run(lua));
  }
}

bool LuaContest::compare(double bar, std::ostream& out) const {
  bool ok = true;
  for (std::size_t i = 0; i < theirs.size(); ++i)
    // The bar compares with Lua 5.4 only, the first peer.
    ok &=
        tools::compare(ours, theirs[i], lua_peers()[i], i == 0 ? bar : 0, out);
  return ok;
}

} // namespace parlour::tools
