#include "adapters/agents/server/mistake_log.hpp"

#include <utility>

#include <fmt/format.h>

namespace parlour::adapters::agents {
MistakeLog::MistakeLog(Write write) : write_(std::move(write)) {}

void MistakeLog::note(const std::string& peer, const WireError& error,
                      Timestamp now) {
  note(std::string(name_of(error.kind)),
       fmt::format("agent {}: {}: {}", peer, name_of(error.kind),
                   error.sentence),
       now);
}

void MistakeLog::note_not_accepted(const std::string& reason, Timestamp now) {
  note("accept", "an agent's connection is not accepted: " + reason, now);
}

void MistakeLog::note(const std::string& name, std::string line,
                      Timestamp now) {
  {
    std::lock_guard lock(mutex_);
    auto& kind = kinds_[name];
    ++kind.count;
    if (kind.written > 0 && now - kind.at < one_line_in.count())
      return;
    if (const auto more = kind.count - kind.written - 1; more > 0)
      line += fmt::format(" (and {} more)", more);
    kind.written = kind.count;
    kind.at = now;
  }
  if (write_)
    write_(line);
}

std::map<std::string, std::uint64_t> MistakeLog::counts() const {
  std::lock_guard lock(mutex_);
  std::map<std::string, std::uint64_t> counts;
  for (const auto& [name, kind] : kinds_)
    counts[name] = kind.count;
  return counts;
}

} // namespace parlour::adapters::agents
