// Listens for the remote agents of an application, and for its taps
// (docs/agents.md).
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "adapters/agents/server/agent_server.hpp"
#include "adapters/agents/zeromq/message_tap.hpp"
#include "runtime/base/settings.hpp"

namespace parlour::tools {

// What <agents> says, for the server; `folder` is the application's. The error,
// at the place in the settings, names an address that cannot be read.
Expected<adapters::agents::ServerOptions>
server_options(const AgentsSettings& agents,
               const std::filesystem::path& folder);

// Null if there are no agents. The error says why nobody can connect, at the
// place in the settings. If `lines` is not empty, agents connect there, by
// lines of text alone, and not where the settings say. `log` gets the mistakes
// of peers, on a thread of the server.
Expected<std::shared_ptr<adapters::agents::AgentServer>>
listen_for_agents(AgentsSettings agents, const std::filesystem::path& folder,
                  const std::string& lines,
                  std::function<void(const std::string&)> log);

// Publishes at `taps`, or else where the settings say. Null if neither names an
// address. The error says why nobody can listen there, at the place in the
// settings.
Expected<std::unique_ptr<adapters::agents::MessageTap>>
open_tap(const AgentsSettings& agents, const std::string& taps);

} // namespace parlour::tools
