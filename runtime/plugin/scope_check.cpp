#include "runtime/plugin/scope_check.hpp"

#include <algorithm>

namespace parlour {

Expected<void> check_scope(const Scope& scope,
                           const PluginDescription& plugin) {
  using enum Scope::Kind;
  const auto& roles = plugin.roles;
  const bool is_database =
      std::find(roles.begin(), roles.end(), "Database") != roles.end();
  if (scope.kind == in_turn && (!plugin.is_inline || plugin.blocks))
    return fail(ErrorKind::settings, "scope=\"inline\" is not for it: it has a "
                                     "state of its own, or waits");
  if (scope.kind == pool && is_database)
    return fail(ErrorKind::settings,
                "scope=\"pool\" is not for a database: a transaction stays "
                "with one instance");
  return {};
}

} // namespace parlour
