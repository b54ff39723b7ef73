// The commands `parlour plugin …`: list what there is, tell of roles, make a
// new one, try one out.
#pragma once

#include <string>
#include <vector>

#include "tools/parlour/console/console.hpp"
#include "tools/parlour/console/places.hpp"

namespace parlour::tools {

// Of the program, and of the plug-in folders seen from `app` or else from the
// working folder.
int plugin_list_command(const Places& places, const std::string& app,
                        const Console& console);

// A role's commands and events; with an empty name, what roles there are.
int plugin_roles_command(const std::string& name, const Console& console);

struct NewPluginOptions {
  std::string name;
  std::string role;
  std::string folder; // empty: of the plug-in's name
};
int plugin_new_command(const Places& places, const NewPluginOptions& options,
                       const Console& console);

struct TestPluginOptions {
  std::string plugin;               // a file, or a name
  std::vector<std::string> options; // "name=value"
};
// In a process of its own, so that it may crash or hang.
int plugin_test_command(const Places& places, const TestPluginOptions& options,
                        const Console& console);

} // namespace parlour::tools
