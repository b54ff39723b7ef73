// Listens for agents that speak in lines of text over TCP, with or without TLS
// (adapters/agents/PROTOCOL.md 2.1, 2.2 and 2.4).
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "adapters/agents/delivery/transport.hpp"
#include "adapters/loop/loop.hpp"
#include "runtime/base/error.hpp"

namespace parlour::adapters::agents {

struct LineOptions {
  std::string address = "127.0.0.1";
  // 0: any port that is free.
  std::uint16_t port = 0;
  // Files in PEM. If both are empty there is no TLS, and only loopback may be
  // used.
  std::string certificate;
  std::string private_key;
};

// Both outlive it. Call it on the loop's thread, where it runs. An error of
// kind Settings says which option is wrong, one of kind Network that the port
// is taken.
Expected<std::unique_ptr<AgentTransport>>
listen_for_lines(Loop& loop, TransportEvents& events,
                 const LineOptions& options);

} // namespace parlour::adapters::agents
