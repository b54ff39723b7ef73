// Names are compared by canonical role, so an alias equals its role.
#include "tools/parlour/application/plugins/module_names.hpp"

#include "runtime/message/roles.hpp"

namespace parlour::tools {

namespace {

// Whether the component fills that role.
bool fills(const std::map<std::string, std::set<std::string>>& roles,
           const std::string& component, const std::string& role) {
  const auto found = roles.find(component);
  return found != roles.end() &&
         found->second.count(std::string(canonical_role(role))) > 0;
}

} // namespace

ModuleNames::ModuleNames(const Composition& composition) {
  for (const auto& component : composition.components) {
    auto& roles = roles_[component.name];
    for (const auto& role : component.factory.description.roles)
      roles.insert(std::string(canonical_role(role)));
  }
}

bool ModuleNames::same(const std::string& one, const std::string& other) const {
  return one == other || canonical_role(one) == canonical_role(other) ||
         fills(roles_, one, other) || fills(roles_, other, one);
}

std::map<std::string, std::string, std::less<>> role_aliases() {
  std::map<std::string, std::string, std::less<>> aliases;
  for (const auto& role : roles())
    for (const auto& alias : role.aliases)
      aliases.emplace(alias, role.name);
  return aliases;
}

} // namespace parlour::tools
