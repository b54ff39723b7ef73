#include "tools/bench/contest.hpp"

#include <ostream>

#include <fmt/format.h>

namespace parlour::tools {

void Series::add(const Expected<Measured>& measured) {
  if (!measured) {
    trouble = measured.error().message;
    return;
  }
  figures.push_back(measured->nanoseconds);
  result = measured->result;
}

std::string verdict(double ratio, double bar) {
  return fmt::format("{:.2f}, bar {:.2f}: {}", ratio, bar,
                     ratio <= bar ? "met" : "missed");
}

bool compare(const Series& ours, const Series& theirs, const LuaPeer& peer,
             double bar, std::ostream& out) {
  if (!peer.is_there()) {
    out << fmt::format("; {}: not built, as {} is missing", peer.title,
                       peer.package);
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

} // namespace parlour::tools
