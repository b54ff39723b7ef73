#include "tools/parlour/application/agent_listener.hpp"

#include <utility>

#include "runtime/base/text/host_and_port.hpp"

namespace parlour::tools {

namespace {

using namespace adapters::agents;

// Absolute, or relative to the application's folder.
std::string file_in(const std::filesystem::path& folder,
                    const std::string& name) {
  return name.empty() ? name : (folder / name).string();
}

// An address of this host and a port, which may be 0: "127.0.0.1:5671" or
// "[::1]:0".
Expected<LineOptions> line_options(const AgentsSettings& agents,
                                   const std::filesystem::path& folder) {
  auto listen = read_host_and_port(agents.lines);
  if (!listen)
    return fail(ErrorKind::settings, "'" + agents.lines +
                                         "' is no address; write "
                                         "127.0.0.1:5671");
  return LineOptions{std::move(listen->host), listen->port,
                     file_in(folder, agents.certificate),
                     file_in(folder, agents.private_key)};
}

ServerOptions::ZeroMQ zeromq_options(const AgentsSettings& agents) {
  ServerOptions::ZeroMQ options;
  options.address = "tcp://" + agents.zeromq;
  options.secret_key = agents.secret_key;
  for (const auto& agent : agents.agents)
    if (!agent.key.empty())
      options.allowed_keys.push_back(agent.key);
  return options;
}

Error at(const SourceLocation& place, Error error) {
  error.place = place;
  return error;
}

} // namespace

Expected<ServerOptions> server_options(const AgentsSettings& agents,
                                       const std::filesystem::path& folder) {
  ServerOptions options;
  for (const auto& agent : agents.agents)
    options.accounts.push_back({agent.name, agent.token, agent.key});
  if (!agents.zeromq.empty())
    options.zeromq = zeromq_options(agents);
  if (agents.lines.empty())
    return options;
  auto lines = line_options(agents, folder);
  if (!lines)
    return tl::make_unexpected(at(agents.place, std::move(lines.error())));
  options.lines = std::move(*lines);
  return options;
}

Expected<std::shared_ptr<AgentServer>>
listen_for_agents(AgentsSettings agents, const std::filesystem::path& folder,
                  const std::string& lines,
                  std::function<void(const std::string&)> log) {
  if (agents.agents.empty())
    return nullptr;
  if (!lines.empty()) {
    agents.lines = lines;
    agents.zeromq.clear();
  }
  auto options = server_options(agents, folder);
  if (!options)
    return tl::make_unexpected(std::move(options.error()));
  options->log = std::move(log);
  auto server = AgentServer::start(std::move(*options));
  if (!server)
    return tl::make_unexpected(at(agents.place, std::move(server.error())));
  return std::shared_ptr<AgentServer>(std::move(*server));
}

Expected<std::unique_ptr<MessageTap>> open_tap(const AgentsSettings& agents,
                                               const std::string& taps) {
  const auto& address = taps.empty() ? agents.taps : taps;
  if (address.empty())
    return nullptr;
  auto tap = MessageTap::open("tcp://" + address);
  if (!tap && taps.empty())
    return tl::make_unexpected(at(agents.place, std::move(tap.error())));
  return tap;
}

} // namespace parlour::tools
