#include "runtime/plugin/component_check.hpp"

#include <algorithm>

namespace parlour {

namespace {

tl::unexpected<Error> wrong(const std::string& name, const std::string& what) {
  return fail(ErrorKind::settings, name + ": " + what);
}

bool fills(const PluginDescription& plugin, std::string_view role) {
  return std::ranges::any_of(plugin.roles, [&](const auto& other) {
    return canonical_role(other) == canonical_role(role);
  });
}

} // namespace

Expected<void> check_component(const std::string& name,
                               const PluginDescription& plugin) {
  if (const auto fault = wrong_source_name(name); !fault.empty())
    return wrong(plugin.name, fault);
  for (const auto& role : plugin.roles)
    if (const auto* known = find_role(role); known && known->reserved)
      return wrong(name, "its plug-in " + plugin.name + " calls itself '" +
                             role +
                             "', which is no role, but a source of the "
                             "platform's own");
  return {};
}

Expected<void> check_replacement(const std::string& name,
                                 const PluginDescription& before,
                                 const PluginDescription& after) {
  for (const auto& role : before.roles)
    if (!fills(after, role))
      return wrong(name, "it is the " + role + " here, which " + after.name +
                             " is not; load " + after.name +
                             " under another name");
  return {};
}

} // namespace parlour
