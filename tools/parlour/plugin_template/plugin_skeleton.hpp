// The files of a new plug-in, for `parlour plugin new`. The result builds
// outside of this tree against an installed Parlour, passes the conformance
// test of its role, and has a handler for each command of the role. Pure:
// writes nothing.
#pragma once

#include <string>
#include <vector>

#include "runtime/base/error.hpp"
#include "runtime/message/roles.hpp"

namespace parlour::tools {

// A file to be written: its name within the plug-in's folder, and its text.
struct SkeletonFile {
  std::string name;
  std::string text;
};

// The roles that a component can have: all but the platform's own sources.
std::vector<std::string> component_roles();

// Finds such a role by its name or alias. The error lists the roles, or
// suggests one. The role is in a static table and never goes away.
Expected<const Role*> component_role(const std::string& name);

// CMakeLists.txt, a source, a test and a README. `name` becomes the class and
// the plug-in's name, and its snake case the file names. Errors of kind
// Settings: `name` is no class name in our style, or there is no such role.
Expected<std::vector<SkeletonFile>> plugin_skeleton(const std::string& name,
                                                    const std::string& role);

} // namespace parlour::tools
