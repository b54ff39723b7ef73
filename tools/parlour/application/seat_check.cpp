#include "tools/parlour/application/seat_check.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "runtime/plugin/test_host.hpp"
#include "tools/parlour/application/plugins/plugin_calls.hpp"
#include "tools/parlour/application/plugins/shipped_plugin.hpp"

namespace parlour::tools {

namespace {

bool is_at_seat(const ChosenComponent& component) {
  constexpr std::array<std::string_view, 6> roles = {
      "Microphone", "PushToTalk", "Enhancement",
      "VAD",        "Endpointer", "Speaker"};
  return component.policy.scope.kind == Scope::Kind::seat &&
         std::ranges::any_of(
             component.factory.description.roles, [&](const auto& role) {
               return std::ranges::find(roles, role) != roles.end();
             });
}

} // namespace

// One after the other, as two may want the same device; the next run starts
// them anew.
std::vector<Error> seat_errors(const Composition& composition,
                               const std::filesystem::path& application,
                               const std::filesystem::path& data) {
  std::vector<Error> errors;
  for (const auto& component : composition.components) {
    if (!is_at_seat(component))
      continue;
    TestHost host; // outlives the plug-in
    host.application = application.string();
    host.data = data.string();
    const auto plugin =
        start_plugin(component.factory, host, component.options);
    if (plugin)
      stop_plugin(**plugin);
    else
      errors.push_back({plugin.error().kind,
                        component.name + ": " + to_string(plugin.error()),
                        {}});
  }
  return errors;
}

const ChosenComponent* key_of_terminal(const Composition& composition) {
  for (const auto& component : composition.components) {
    const auto takes =
        shipped_plugin(component.factory.description.name).takes_terminal;
    if (takes && component.policy.scope.instances > 0 &&
        takes(component.options))
      return &component;
  }
  return nullptr;
}

} // namespace parlour::tools
