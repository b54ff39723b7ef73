// The files of a new plug-in: it builds outside of our tree, passes the role's
// conformance test, and has a place for each command of the role. Pure.
#pragma once

#include <string>
#include <vector>

#include "runtime/base/error.hpp"
#include "runtime/base/roles.hpp"

namespace parlour::tools {

struct SkeletonFile {
  std::string name;
  std::string text;
};

// The roles that a component may have.
std::vector<std::string> component_roles();

// By name or alias; the error says what roles there are.
Expected<const Role*> component_role(const std::string& name);

// Errors, of kind Settings: the name is none of a class, or there is no such
// role for a component.
Expected<std::vector<SkeletonFile>> plugin_skeleton(const std::string& name,
                                                    const std::string& role);

} // namespace parlour::tools
