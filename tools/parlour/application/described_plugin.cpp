#include "tools/parlour/application/described_plugin.hpp"

#include "adapters/http/http_service.hpp"

namespace parlour::tools {

void complete_description(PluginDescription& plugin, const Options& options,
                          const std::filesystem::path& application_folder) {
  if (plugin.name == "HTTPService")
    adapters::http::describe_by_rules(plugin, options,
                                      application_folder.string());
}

} // namespace parlour::tools
