// Our side of the rows `lines` and `zeromq` of `parlour bench agents`: an agent
// and the platform's server in one process, with everything that the protocol
// promises.
#pragma once

#include "runtime/base/error.hpp"
#include "tools/bench/agents/bench_agent.hpp"
#include "tools/bench/agents/exchange.hpp"

namespace parlour::tools {

// Messages have one parameter of exchanged_bytes. One way they go from the
// agent to the platform; in round trips the platform asks and the agent
// answers. All are numbered, acknowledged and kept until then. The error says
// that a message was lost.
Expected<Exchanged> agents_exchange(AgentTransport transport,
                                    const ExchangeCount& count);

} // namespace parlour::tools
