// An agent and its component in one process, which the rows of `parlour bench
// agents` share.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "adapters/agents/client/agent_connection.hpp"
#include "adapters/agents/server/agent_server.hpp"
#include "runtime/base/error.hpp"

namespace parlour::tools {

enum class AgentTransport : unsigned char { lines, zeromq };

std::string_view name_of(AgentTransport transport);

// The name of the agent with this number.
std::string bench_agent_name(std::size_t number);

// On loopback and any free port, for so many agents.
Expected<std::unique_ptr<adapters::agents::AgentServer>>
start_bench_server(AgentTransport transport, std::size_t agents);

// Where it listens.
adapters::agents::PlatformAddress
bench_address(const adapters::agents::AgentServer& server,
              AgentTransport transport);

// An agent that is connected to a server.
class BenchAgent {
public:
  // What one side does with a message, on the thread that reads it.
  using Take = std::function<void(adapters::agents::AgentMessage&& message)>;

  // Waits until the server knows the agent. The error says that it does not.
  static Expected<BenchAgent> connect(adapters::agents::AgentServer& server,
                                      AgentTransport transport,
                                      const std::string& name, Take platform,
                                      Take agent = {});
  BenchAgent(BenchAgent&&) noexcept;
  BenchAgent& operator=(BenchAgent&&) noexcept;
  ~BenchAgent();

  adapters::agents::AgentConnection& connection();
  // What the server has refused or found wrong; empty if all is well. Once the
  // agent is quiet.
  const std::string& trouble() const;

private:
  struct Sides;
  explicit BenchAgent(std::unique_ptr<Sides> sides);
  std::unique_ptr<Sides> sides_;
};

} // namespace parlour::tools
