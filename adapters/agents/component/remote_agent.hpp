// The component of a remote agent: to scripts and other components an agent is
// a component like any other (docs/agents.md). While the agent is away, the
// component is not available (PluginHost::available).
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "adapters/agents/server/agent_server.hpp"
#include "runtime/base/clock.hpp"
#include "runtime/plugin/plugin.hpp"

namespace parlour::adapters::agents {

struct RemoteAgentOrder {
  std::string name;               // the agent's
  std::vector<std::string> roles; // that it fills
  // For how long an agent may expect that somebody waits for its answer.
  Milliseconds patience{};
};

// Makes the component of an agent. Without a server nobody can connect: the
// agent is away for ever.
PluginFactory remote_agent(RemoteAgentOrder order,
                           std::shared_ptr<AgentServer> server);

} // namespace parlour::adapters::agents
