// `parlour agent`: runs a plug-in as a remote agent (docs/agents.md).
#include <ostream>

#include "adapters/agents/client/plugin_agent.hpp"
#include "adapters/network/address.hpp"
#include "tools/parlour/application/data_folder.hpp"
#include "tools/parlour/application/plugins/shipped_plugin.hpp"
#include "tools/parlour/cli/commands.hpp"
#include "tools/parlour/cli/plugins/given_plugin.hpp"
#include "tools/parlour/console/exit_code.hpp"
#include "tools/parlour/console/printer.hpp"
#include "tools/parlour/console/signal_watch.hpp"

namespace parlour::tools {

namespace {

using namespace adapters::agents;

// "tcp://HOST:PORT" or "tls://HOST:PORT".
Expected<PlatformAddress> platform_address(const AgentOptions& options) {
  const auto& text = options.connect;
  const bool is_encrypted = text.starts_with("tls://");
  if (!is_encrypted && !text.starts_with("tcp://"))
    return fail(ErrorKind::settings,
                "--connect " + text +
                    ": say tcp://HOST:PORT, or tls://HOST:PORT");
  auto address = adapters::parse_address(text.substr(6));
  if (!address)
    return tl::make_unexpected(std::move(address.error()));
  return PlatformAddress{address->host, address->port, is_encrypted,
                         options.authority};
}

Expected<PluginAgentOrder> order_of(const Places& places,
                                    const AgentOptions& options) {
  auto address = platform_address(options);
  if (!address)
    return tl::make_unexpected(std::move(address.error()));
  auto factory = given_plugin(places, options.plugin);
  if (!factory)
    return tl::make_unexpected(std::move(factory.error()));
  auto given = given_options(options.options, factory->description);
  if (!given)
    return tl::make_unexpected(std::move(given.error()));
  complete_description(factory->description, *given, places.working);
  PluginAgentOrder order;
  order.name = options.name.empty() ? factory->description.name : options.name;
  order.token = places.environment("PARLOUR_TOKEN").value_or("");
  order.address = std::move(*address);
  order.factory = std::move(*factory);
  order.options = std::move(*given);
  return order;
}

int give_up(const Console& console, const Error& error) {
  say_error(console, to_string(error));
  return exit_code::wrong;
}

} // namespace

int agent_command(const Places& places, const AgentOptions& options,
                  const Console& console) {
  SignalWatch signals; // before any other thread
  auto order = order_of(places, options);
  if (!order) {
    say_error(console, order.error().message);
    return exit_code::usage;
  }
  const auto data = options.data.empty()
                        ? DataFolder::temporary()
                        : DataFolder::open(places.working / options.data);
  if (!data)
    return give_up(console, data.error());
  order->data_folder = data->path().string();
  Printer printer(console.out, console.err, [] {});
  order->log = [&printer](const std::string& line) { printer.err(line); };
  PluginAgent agent(std::move(*order));
  signals.on_interrupt([&] { agent.stop(); });
  const auto outcome = agent.run();
  signals.on_interrupt(nullptr);
  printer.finish();
  return outcome ? signals.status() : give_up(console, outcome.error());
}

} // namespace parlour::tools
