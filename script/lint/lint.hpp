// Lints: warnings about an application that compiles but probably does not do
// what was meant (lints.def; language rule 14.1). Pure: reads the compiled
// application and adds findings.
//
// Errors of the language are found by the compiler; here is only what is
// allowed and suspicious. Authors silence a warning by a comment
// (script/xml/allowances.hpp).
#pragma once

#include <map>
#include <string>
#include <vector>

#include "script/compiler/compiler.hpp"

namespace parlour::script::lint {

// What is known of the application's components.
struct Options {
  // The roles that each component of the settings fills.
  std::map<std::string, std::vector<std::string>> component_roles{};
  // The commands that each component understands beyond its roles.
  std::map<std::string, std::vector<std::string>> component_commands{};
};

// Adds warnings to `compiled.findings` and removes those that comments allow.
// Does nothing if there are errors, which would cause misleading warnings.
void lint(Compiled& compiled, const Options& options);

} // namespace parlour::script::lint
