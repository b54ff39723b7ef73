#include "adapters/agents/server/mistake_log.hpp"

#include <utility>

#include <fmt/format.h>

namespace parlour::adapters::agents {
namespace {

std::string line_about(const std::string& peer, const WireError& error,
                       std::uint64_t more) {
  auto line = fmt::format("agent {}: {}: {}", peer, name_of(error.kind),
                          error.sentence);
  return more == 0 ? line : fmt::format("{} (and {} more)", line, more);
}

} // namespace

MistakeLog::MistakeLog(Write write) : write_(std::move(write)) {}

void MistakeLog::note(const std::string& peer, const WireError& error,
                      Timestamp now) {
  std::string line;
  {
    std::lock_guard lock(mutex_);
    auto& kind = kinds_[std::string(name_of(error.kind))];
    ++kind.count;
    if (kind.written > 0 && now - kind.at < one_line_in.count())
      return;
    line = line_about(peer, error, kind.count - kind.written - 1);
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
