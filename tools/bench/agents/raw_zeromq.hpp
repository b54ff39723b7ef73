// The peer of agents that use ZeroMQ: the library alone, without numbers and
// acknowledgements.
#pragma once

#include "runtime/base/error.hpp"
#include "tools/bench/agents/exchange.hpp"

namespace parlour::tools {

struct RawZeroMQ {
  // Of a message; the last one has all bytes but a few.
  int frames = 1;
  // Both sides share one thread for their sockets, as they cannot where they
  // are two processes.
  bool share_thread = true;
};

// One way from PUSH to PULL, which is the fastest that ZeroMQ has; round trips
// from DEALER to ROUTER and back.
Expected<Exchanged> raw_zeromq_exchange(const RawZeroMQ& way,
                                        const ExchangeCount& count);

} // namespace parlour::tools
