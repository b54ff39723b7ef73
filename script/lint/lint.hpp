// Looks at an application that compiles for what is probably not meant
// (lints.def). Pure: reads the compiled application, adds findings.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "script/compiler/compiler.hpp"

namespace parlour::script::lint {

struct Options {
  // Of each component of the settings, the roles that it fills.
  std::map<std::string, std::vector<std::string>> component_roles{};
  // And what it understands beyond them.
  std::map<std::string, std::vector<std::string>> component_commands{};
};

// Adds warnings to `compiled.findings`, without those that their files allow.
// Does nothing where there are errors, which would only cause more.
void lint(Compiled& compiled, const Options& options);

} // namespace parlour::script::lint
