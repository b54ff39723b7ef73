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
#include "runtime/base/limited_log.hpp"

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
  void note(const std::string& kind, const std::string& text, Timestamp now);

  Write write_;
  mutable std::mutex mutex_;
  LimitedLog<std::string> log_{one_line_in};
};

} // namespace parlour::adapters::agents
