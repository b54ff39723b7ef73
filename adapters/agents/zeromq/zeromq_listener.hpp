// Listens for agents that connect a DEALER socket of ZeroMQ to the platform's
// ROUTER socket (adapters/agents/PROTOCOL.md 2.3 and 2.4).
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "adapters/agents/delivery/transport.hpp"
#include "adapters/loop/loop.hpp"
#include "runtime/base/error.hpp"

namespace parlour::adapters::agents {

struct ZeroMQOptions {
  // `*`: any port that is free.
  std::string address = "tcp://127.0.0.1:*";
  // The platform's secret key for CURVE, as Z85 text of 40 characters
  // (new_key_pair). If it is empty, nothing is encrypted, and only a loopback
  // address is allowed.
  std::string secret_key;
  // The public keys of the agents that may connect.
  std::vector<std::string> allowed_keys;
};

// `loop` and `events` must outlive the transport. Call it on the loop's thread,
// where the transport runs. The kind of an error is Settings if an option is
// wrong, and Network if the port is in use.
Expected<std::unique_ptr<AgentTransport>>
listen_by_zeromq(Loop& loop, TransportEvents& events,
                 const ZeroMQOptions& options);

} // namespace parlour::adapters::agents
