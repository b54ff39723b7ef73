// An agent's connection to the platform by ZeroMQ (adapters/agents/PROTOCOL.md
// 2.3 and 2.4): a DEALER socket.
#pragma once

#include <memory>
#include <string>

#include "adapters/agents/delivery/peer_connection.hpp"
#include "adapters/agents/zeromq/key_pair.hpp"
#include "adapters/loop/loop.hpp"
#include "runtime/base/error.hpp"

namespace parlour::adapters::agents {

struct ZeroMQPlatform {
  std::string address; // "tcp://host:port"
  // For CURVE: the agent's own keys, and the platform's public key, as Z85 text
  // of 40 characters. If they are empty, nothing is encrypted.
  KeyPair own;
  std::string platform_key;
};

// ZeroMQ does not tell whether anybody is there: whoever hears nothing gives
// the connection up. `loop` and `owner` must outlive it. Call it on the loop's
// thread, where it runs. The error, of kind Settings, says that the address or
// a key is wrong.
Expected<std::shared_ptr<PeerConnection>>
connect_by_zeromq(Loop& loop, ConnectionId id, PeerConnection::Owner& owner,
                  const ZeroMQPlatform& platform);

} // namespace parlour::adapters::agents
