// The peer of agents that speak in lines: two threads with a TCP connection and
// nothing else. No format, no numbers, no acknowledgements.
#pragma once

#include "runtime/base/error.hpp"
#include "tools/bench/agents/exchange.hpp"

namespace parlour::tools {

// One way, 64 KiB of messages are written at once.
Expected<Exchanged> raw_tcp_exchange(const ExchangeCount& count);

} // namespace parlour::tools
