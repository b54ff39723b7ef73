// ModuleNames: whether two names mean the same component: by its own name, by
// a role that it fills, or by the role's alias.
#pragma once

#include <map>
#include <set>
#include <string>

#include "tools/parlour/application/composition.hpp"

namespace parlour::tools {

class ModuleNames {
public:
  explicit ModuleNames(const Composition& composition);

  bool same(const std::string& one, const std::string& other) const;

private:
  std::map<std::string, std::set<std::string>> roles_; // of each component
};

// Aliases of roles, as the node wants them.
std::map<std::string, std::string, std::less<>> role_aliases();

} // namespace parlour::tools
