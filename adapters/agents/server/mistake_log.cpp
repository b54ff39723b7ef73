#include "adapters/agents/server/mistake_log.hpp"

#include <chrono>
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

void MistakeLog::note(const std::string& kind, const std::string& text,
                      Timestamp now) {
  std::unique_lock lock(mutex_);
  const auto line = log_.note(
      kind, text, std::chrono::steady_clock::time_point(Milliseconds(now)));
  lock.unlock();
  if (line && write_)
    write_(*line);
}

std::map<std::string, std::uint64_t> MistakeLog::counts() const {
  std::lock_guard lock(mutex_);
  return log_.counts();
}

} // namespace parlour::adapters::agents
