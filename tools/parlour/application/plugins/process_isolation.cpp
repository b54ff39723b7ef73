// Wraps a plug-in so that it runs in a child process (adapters/process).
#include "tools/parlour/application/plugins/process_isolation.hpp"

#include <cstdlib>
#include <utility>

#include "adapters/process/process_plugin.hpp"

namespace parlour::tools {

PluginFactory hosted(PluginFactory factory, const ComponentPolicy& policy,
                     const std::filesystem::path& file) {
  // "usual" lets an inline plug-in be called in the session's turn; a plug-in
  // from a file gets a mailbox and a thread instead.
  if (!file.empty() && policy.scope.kind == Scope::Kind::usual)
    factory.description.is_inline = false;
  if (policy.host != "process")
    return factory;
  adapters::ProcessOrder order;
  if (const auto* program = std::getenv("PARLOUR_PROGRAM"))
    order.program = program;
  // The arguments of `parlour component` (cli/component_command.cpp).
  order.arguments = {"component", factory.description.name};
  if (!file.empty())
    order.arguments.insert(order.arguments.end(),
                           {"--plugins", file.parent_path().string()});
  order.answer_within = policy.deadline.value_or(order.answer_within);
  return adapters::out_of_process(std::move(factory.description),
                                  std::move(order));
}

} // namespace parlour::tools
