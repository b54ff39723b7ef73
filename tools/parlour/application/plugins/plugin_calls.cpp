#include "tools/parlour/application/plugins/plugin_calls.hpp"

#include <exception>
#include <string>

namespace parlour::tools {

Expected<void> call_plugin(const std::function<void()>& action) {
  try {
    action();
    return {};
  } catch (const std::exception& exception) {
    return fail(ErrorKind::refused,
                "it throws '" + std::string(exception.what()) + "'");
  } catch (...) {
    return fail(ErrorKind::refused, "it throws something");
  }
}

Expected<std::unique_ptr<IPlugin>> start_plugin(const PluginFactory& factory,
                                                PluginHost& host,
                                                const Options& options) {
  std::unique_ptr<IPlugin> plugin;
  Expected<void> started;
  const auto called = call_plugin([&] {
    plugin = factory.create();
    started = plugin->start(host, options);
  });
  if (!called)
    return tl::make_unexpected(called.error());
  if (!started)
    return tl::make_unexpected(started.error());
  return plugin;
}

Expected<void> send_to_plugin(IPlugin& plugin, const Message& message) {
  return call_plugin([&] { plugin.receive(message); });
}

void stop_plugin(IPlugin& plugin) {
  (void)call_plugin([&] { plugin.stop(); });
}

} // namespace parlour::tools
