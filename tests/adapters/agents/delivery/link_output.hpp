// What links are given in tests, and what they write, as a list.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "adapters/agents/delivery/link.hpp"

namespace parlour::adapters::agents {

inline AgentMessage numbered(std::uint64_t what) {
  AgentMessage message;
  message.command = std::to_string(what);
  return message;
}

inline std::vector<AgentMessage> output_of(Link& link, Timestamp now) {
  std::vector<AgentMessage> output;
  link.write_output(
      now, [&](const AgentMessage& message) { output.push_back(message); });
  return output;
}

} // namespace parlour::adapters::agents
