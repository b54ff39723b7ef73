#include "tools/parlour/application/node_options.hpp"

#include "adapters/files/data_files.hpp"
#include "adapters/network/tcp_sockets.hpp"
#include "script/run/phrase_evaluator.hpp"
#include "tools/parlour/application/hosting.hpp"
#include "tools/parlour/application/module_names.hpp"

namespace parlour::tools {

namespace {

// What a plug-in hears from a server comes in real time: where time is virtual
// it has to be there before the next message.
void fit_to_time(actors::ComponentOrder& order, bool is_virtual) {
  for (const auto& option : order.factory.description.options)
    if (is_virtual && option.name == "one-by-one")
      order.options[option.name] = "true";
}

} // namespace

actors::NodeOptions node_options(const Application& application,
                                 const Composition& composition,
                                 const RunWishes& wishes) {
  actors::NodeOptions options;
  options.program = application.program;
  const bool is_virtual = wishes.virtual_start.has_value();
  for (const auto& component : composition.components) {
    options.components.push_back({component.name, component.factory,
                                  component.options, component.upkeep});
    fit_to_time(options.components.back(), is_virtual);
  }
  options.plugins = application.plugins;
  options.complete = [plugins = application.plugins,
                      is_virtual](actors::ComponentOrder& order) {
    const auto file = plugins->file_of(order.factory.description.name);
    order.factory = hosted(std::move(order.factory), order.upkeep, file);
    fit_to_time(order, is_virtual);
  };
  options.aliases = role_aliases();
  options.phrases = script::make_phrase_evaluator(application.program);
  options.columns =
      column_reader(composition, application.folder, wishes.data_folder);
  options.virtual_start = wishes.virtual_start;
  options.seed = wishes.seed;
  options.data_folder = wishes.data_folder;
  options.application_folder = application.folder.string();
  if (!wishes.data_folder.empty())
    options.files = adapters::data_files(wishes.data_folder);
  // What comes from a network comes in real time.
  if (!wishes.virtual_start)
    options.sockets = std::make_shared<adapters::TcpSockets>();
  return options;
}

} // namespace parlour::tools
