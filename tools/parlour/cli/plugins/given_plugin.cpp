#include "tools/parlour/cli/plugins/given_plugin.hpp"

#include "adapters/plugins/plugin_file.hpp"
#include "tools/parlour/application/plugins/catalogue.hpp"
#include "tools/parlour/application/plugins/option_check.hpp"

namespace parlour::tools {

Expected<PluginFactory> given_plugin(const Places& places,
                                     const std::string& plugin) {
  const auto path = places.working / plugin;
  if (path.extension() == ".so")
    return adapters::open_plugin_file(path);
  return Catalogue(plugin_folders(places, places.working)).find(plugin);
}

Expected<Options> given_options(const std::vector<std::string>& given,
                                const PluginDescription& plugin) {
  Options options;
  for (const auto& text : given) {
    const auto equals = text.find('=');
    if (equals == std::string::npos)
      return fail(ErrorKind::settings,
                  "--option " + text + " lacks its '=value'");
    options[text.substr(0, equals)] = text.substr(equals + 1);
  }
  const auto mistakes = option_mistakes(plugin.name, plugin, options);
  if (!mistakes.empty())
    return fail(ErrorKind::settings, mistakes.front().text);
  return options;
}

} // namespace parlour::tools
