// LimitedLog counts what goes wrong, by its kind, and says when a line about it
// is due: whoever sends rubbish must not fill the log. No clock, no thread.
#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "runtime/base/clock.hpp"

namespace parlour {

// Each kind is limited by itself: one that floods does not hide another. Kinds
// are never forgotten, so who sends may not invent them.
template <class Kind>
class LimitedLog {
public:
  using Moment = std::chrono::steady_clock::time_point;

  // Of each kind there is one line in this time.
  explicit LimitedLog(Milliseconds one_line_in) : one_line_in_(one_line_in) {}

  // Counts it, and returns the line to log, if one is due: "… is no state of
  // 'door' (and 41 more)" where there were so many without a line.
  std::optional<std::string> note(const Kind& of, const std::string& text,
                                  Moment now) {
    auto& kind = kinds_[of];
    ++kind.count;
    if (kind.written > 0 && now - kind.at < one_line_in_)
      return {};
    const auto more = kind.count - kind.written - 1;
    kind.written = kind.count;
    kind.at = now;
    return more == 0 ? text : text + " (and " + std::to_string(more) + " more)";
  }

  std::uint64_t count(const Kind& of) const {
    const auto found = kinds_.find(of);
    return found == kinds_.end() ? 0 : found->second.count;
  }
  // Of the kinds that were noted.
  std::map<Kind, std::uint64_t> counts() const {
    std::map<Kind, std::uint64_t> counts;
    for (const auto& [name, kind] : kinds_)
      counts[name] = kind.count;
    return counts;
  }

private:
  struct Noted {
    std::uint64_t count = 0;
    // How many there were at the last line, and when that was.
    std::uint64_t written = 0;
    Moment at = {};
  };

  Milliseconds one_line_in_;
  std::map<Kind, Noted> kinds_;
};

} // namespace parlour
