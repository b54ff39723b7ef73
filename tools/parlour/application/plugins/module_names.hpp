// ModuleNames: whether two names address the same component. A component is
// addressed by its own name, by a role that it fills, or by an alias of the
// role.
#pragma once

#include <map>
#include <set>
#include <string>

#include "tools/parlour/application/plugins/composition.hpp"

namespace parlour::tools {

class ModuleNames {
public:
  // Copies what it needs of the composition.
  explicit ModuleNames(const Composition& composition);

  bool same(const std::string& one, const std::string& other) const;

private:
  std::map<std::string, std::set<std::string>> roles_; // of each component
};

// Role aliases as NodeOptions::aliases: "Record" is "Microphone".
std::map<std::string, std::string, std::less<>> role_aliases();

} // namespace parlour::tools
