// Who is at the other end of a connection.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace parlour::adapters::agents {

// Names a connection. A server never uses an id twice.
using ConnectionId = std::uint64_t;

// As far as its transport knows.
struct Peer {
  // For logs.
  std::string name;
  // The public key that CURVE has verified, or an empty text; nothing on a
  // transport without keys, where a token counts instead.
  std::optional<std::string> key;
  // The peer may be on another host: it must have a key or a token.
  bool is_remote = false;
};

} // namespace parlour::adapters::agents
