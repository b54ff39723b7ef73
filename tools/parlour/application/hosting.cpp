#include "tools/parlour/application/hosting.hpp"

#include <cstdlib>
#include <utility>

#include "adapters/process/process_plugin.hpp"

namespace parlour::tools {

PluginFactory hosted(PluginFactory factory, const Upkeep& upkeep,
                     const std::filesystem::path& file) {
  if (!file.empty() && upkeep.scope.kind == Scope::Kind::usual)
    factory.description.is_inline = false;
  if (upkeep.host != "process")
    return factory;
  adapters::ProcessOrder order;
  if (const auto* program = std::getenv("PARLOUR_PROGRAM"))
    order.program = program;
  order.arguments = {"component", factory.description.name};
  if (!file.empty())
    order.arguments.insert(order.arguments.end(),
                           {"--plugins", file.parent_path().string()});
  order.answer_within = upkeep.deadline;
  return adapters::out_of_process(std::move(factory.description),
                                  std::move(order));
}

} // namespace parlour::tools
