#include "tools/parlour/application/agent_listener.hpp"

#include <charconv>
#include <cstdint>
#include <utility>

namespace parlour::tools {

namespace {

using namespace adapters::agents;

// Absolute, or relative to the application's folder.
std::string file_in(const std::filesystem::path& folder,
                    const std::string& name) {
  return name.empty() ? name : (folder / name).string();
}

Expected<std::uint16_t> read_port(const std::string& text) {
  std::uint16_t port = 0;
  const auto* end = text.data() + text.size();
  const auto [stopped, error] = std::from_chars(text.data(), end, port);
  if (error != std::errc() || stopped != end)
    return fail(ErrorKind::settings, "'" + text + "' is no port");
  return port;
}

// An address of this host and a port, which may be 0: "127.0.0.1:5671" or
// "[::1]:0".
Expected<LineOptions> line_options(const AgentsSettings& agents,
                                   const std::filesystem::path& folder) {
  const auto& text = agents.lines;
  const auto colon = text.rfind(':');
  if (colon == std::string::npos)
    return fail(ErrorKind::settings,
                "'" + text + "' is no address; write 127.0.0.1:5671");
  const auto port = read_port(text.substr(colon + 1));
  if (!port)
    return tl::make_unexpected(port.error());
  auto host = text.substr(0, colon);
  if (host.starts_with('[') && host.ends_with(']'))
    host = host.substr(1, host.size() - 2);
  return LineOptions{host, *port, file_in(folder, agents.certificate),
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
