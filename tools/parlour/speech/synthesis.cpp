#include "tools/parlour/speech/synthesis.hpp"

#include <fmt/format.h>

#include "runtime/plugin/test_host.hpp"
#include "tools/parlour/application/plugins/plugin_calls.hpp"
#include "tools/parlour/speech/spoken.hpp"

namespace parlour::tools {

namespace {

// What is thrown is trouble.
void call(const std::function<void()>& action, Spoken& spoken) {
  if (const auto called = call_plugin(action); !called)
    spoken.trouble = called.error().message;
}

bool take_events(TestHost& host, Spoken& spoken) {
  const auto events = host.take_events();
  for (const auto& event : events)
    spoken.take(event);
  for (const auto& failure : host.take_failures())
    spoken.trouble = failure;
  return !events.empty() || spoken.is_over();
}

// Waits for the next events. The plug-in's delays run meanwhile.
void take_next(TestHost& host, Spoken& spoken, Milliseconds patience) {
  bool is_something = false;
  call(
      [&] {
        is_something =
            host.wait([&] { return take_events(host, spoken); }, patience);
      },
      spoken);
  if (!is_something && !spoken.is_over())
    spoken.trouble =
        fmt::format("it has said nothing for {} s", patience.count() / 1'000);
}

Message order(const std::string& text) {
  Message message;
  message.session = "say";
  message.command = "Speak";
  message.params = {text, 1};
  return message;
}

} // namespace

Expected<std::vector<adapters::Sample>> synthesize(const PluginFactory& factory,
                                                   const Options& options,
                                                   const std::string& text,
                                                   Milliseconds patience) {
  const auto& name = factory.description.name;
  TestHost host; // outlives the plug-in
  const auto plugin = start_plugin(factory, host, options);
  if (!plugin)
    return fail(plugin.error().kind, name + ": " + to_string(plugin.error()));
  Spoken spoken;
  call([&] { (*plugin)->receive(order(text)); }, spoken);
  while (!spoken.is_over())
    take_next(host, spoken, patience);
  stop_plugin(**plugin);
  if (!spoken.trouble.empty())
    return fail(ErrorKind::refused, name + ": " + spoken.trouble);
  if (spoken.samples.empty())
    return fail(ErrorKind::refused,
                name + ": there is nothing to be heard of that");
  return std::move(spoken.samples);
}

} // namespace parlour::tools
