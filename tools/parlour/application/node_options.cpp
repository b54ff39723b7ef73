// Puts together what a node needs: components, plug-ins, columns, files,
// sockets.
#include "tools/parlour/application/node_options.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#include "adapters/files/data_files.hpp"
#include "adapters/network/tcp_sockets.hpp"
#include "script/run/phrase_evaluator.hpp"
#include "tools/parlour/application/plugins/module_names.hpp"
#include "tools/parlour/application/plugins/process_isolation.hpp"
#include "tools/parlour/application/plugins/shipped_plugin.hpp"

namespace parlour::tools {

namespace {

using Owners = std::function<std::string(const std::string& component)>;

bool has_option(const actors::ComponentOrder& order, std::string_view name) {
  return std::ranges::count(order.factory.description.options, name,
                            &OptionDescription::name) > 0;
}

// In virtual time a plug-in must answer before the next message is handled. One
// that talks to a server in real time has the option "one-by-one" for that; a
// database looks at no clock to see what others have written.
void fit_to_time(actors::ComponentOrder& order, bool is_virtual) {
  if (is_virtual && has_option(order, "one-by-one"))
    order.options["one-by-one"] = "true";
  if (is_virtual && has_option(order, "watch"))
    order.options["watch"] = "0s";
}

// A database tells of new values in the columns that slots and grammars use
// (engine rule 1.9).
void name_columns(actors::ComponentOrder& order, const Owners& owners) {
  if (!has_option(order, "columns") || order.options.contains("columns"))
    return;
  if (auto columns = owners(order.name); !columns.empty())
    order.options["columns"] = std::move(columns);
}

Owners owners_of(const Application& application,
                 const Composition& composition) {
  const auto& model = application.program->understanding;
  return column_owners(composition, model ? column_names(*model)
                                          : std::vector<std::string>());
}

// Where agents can connect, an agent's own plug-in stands in the place of its
// stand-in; the stand-in's options are not for it.
actors::ComponentOrder order_of(const ChosenComponent& component,
                                const RunWishes& wishes, const Owners& owners) {
  actors::ComponentOrder order{component.name, component.factory,
                               component.options, component.policy};
  if (component.agent && wishes.agents) {
    order.factory =
        adapters::agents::remote_agent(*component.agent, wishes.agents);
    order.options.clear();
  }
  name_columns(order, owners);
  fit_to_time(order, wishes.virtual_start.has_value());
  return order;
}

} // namespace

actors::NodeOptions node_options(const Application& application,
                                 const Composition& composition,
                                 const RunWishes& wishes) {
  actors::NodeOptions options;
  options.program = application.program;
  const auto owners = owners_of(application, composition);
  const bool is_virtual = wishes.virtual_start.has_value();
  for (const auto& component : composition.components)
    options.components.push_back(order_of(component, wishes, owners));
  options.plugins = application.plugins;
  // Components that scripts <load> get the same treatment as those of the
  // settings.
  options.complete = [plugins = application.plugins,
                      folder = application.folder,
                      is_rehearsed = composition.is_rehearsed, is_virtual,
                      owners](actors::ComponentOrder& order) {
    complete_description(order.factory.description, order.options, folder);
    const auto file = plugins->file_of(order.factory.description.name);
    order.factory = hosted(std::move(order.factory), order.policy, file);
    // Last: what stands in runs here, as in the settings' components.
    if (is_rehearsed)
      rehearse(order.factory, order.options);
    name_columns(order, owners);
    fit_to_time(order, is_virtual);
  };
  options.aliases = role_aliases();
  options.phrases = script::make_phrase_evaluator(application.program);
  options.columns =
      column_reader(composition, application.folder, wishes.data_folder);
  options.virtual_start = wishes.virtual_start;
  options.seed = wishes.seed;
  options.restores_after_each_input = wishes.restores_after_each_input;
  options.data_folder = wishes.data_folder;
  options.application_folder = application.folder.string();
  if (!wishes.data_folder.empty())
    options.files = adapters::data_files(wishes.data_folder);
  // Network input arrives in real time, so virtual time has no sockets.
  if (!wishes.virtual_start)
    options.sockets = std::make_shared<adapters::TcpSockets>();
  return options;
}

} // namespace parlour::tools
