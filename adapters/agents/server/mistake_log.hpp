// MistakeLog counts the mistakes of agents and of strangers, and connections
// that could not be accepted, and writes a line about them
// (adapters/agents/PROTOCOL.md 5). Whoever sends rubbish must not fill the log:
// of each kind there is one line a second at most.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <string>

#include "adapters/agents/wire/wire_error.hpp"
#include "runtime/base/clock.hpp"

namespace parlour::adapters::agents {

// counts() may be called from any thread, the rest from one.
class MistakeLog {
public:
  using Write = std::function<void(const std::string& line)>;
  static constexpr Milliseconds one_line_in{1000};

  // `write` may be empty: then mistakes are only counted.
  explicit MistakeLog(Write write);

  void note(const std::string& peer, const WireError& error, Timestamp now);
  // The kind is "accept".
  void note_not_accepted(const std::string& reason, Timestamp now);
  // By the name of their kind.
  std::map<std::string, std::uint64_t> counts() const;

private:
  struct Kind {
    std::uint64_t count = 0;
    // How many there were at the last line, and when that was.
    std::uint64_t written = 0;
    Timestamp at = 0;
  };

  void note(const std::string& kind, std::string line, Timestamp now);

  Write write_;
  mutable std::mutex mutex_;
  std::map<std::string, Kind> kinds_;
};

} // namespace parlour::adapters::agents
