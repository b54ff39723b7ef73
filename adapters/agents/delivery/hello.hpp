// The messages with which a connection begins: an agent's hello, and the
// welcome of the platform (adapters/agents/PROTOCOL.md 3).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "adapters/agents/delivery/link.hpp"
#include "adapters/agents/wire/agent_message.hpp"

namespace parlour::adapters::agents {

// The versions of the protocol that this program speaks.
inline constexpr std::uint64_t newest_version = 1;
inline constexpr std::uint64_t oldest_version = 1;

// What an agent says about itself.
struct Hello {
  std::string name;
  // The newest and the oldest version of the protocol that the agent speaks.
  std::uint64_t version = newest_version;
  std::uint64_t oldest = oldest_version;
  Introduction introduction;
  std::vector<std::string> roles;
  // The agent reads parameters in JSON.
  bool json = false;
  std::string token;

  bool operator==(const Hello&) const = default;
};

AgentMessage hello_message(const Hello& hello);
// Reads a hello. The error has the kind `malformed` if a value does not fit its
// key. Keys of later versions are ignored.
Read<Hello> hello_of(const AgentMessage& message);

// The versions of the protocol that a side speaks.
struct Versions {
  std::uint64_t oldest = oldest_version;
  std::uint64_t newest = newest_version;
};

// The newest version that both sides speak, or an error of kind `version`.
Read<std::uint64_t> common_version(const Hello& hello, Versions own = {});

AgentMessage welcome_message(const Introduction& introduction,
                             std::uint64_t version);
// What the platform says about itself.
struct Welcome {
  std::uint64_t version = newest_version;
  Introduction introduction;
};
Read<Welcome> welcome_of(const AgentMessage& message);
// Whether the version is one of those that the agent's hello has offered. The
// error has the kind `version`.
Read<void> check_version(const Welcome& welcome, const Hello& hello);

// The message that reports an error to an agent.
AgentMessage error_message(const WireError& error);

// 16 hexadecimal digits from the system's source of random numbers. They tell
// one process of an agent from the next.
std::string new_incarnation();

} // namespace parlour::adapters::agents
