// The composition root's table: which plug-ins this program has, and which of
// them an application's settings chose, with which options (architecture rule
// 7). Knows every adapter; nobody else does.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "runtime/base/settings.hpp"
#include "runtime/plugin/plugin.hpp"
#include "script/findings.hpp"

namespace parlour::tools {

// One component instance that the settings ask for.
struct ChosenComponent {
  std::string name;
  PluginFactory factory;
  Options options;
  Place place; // in the settings
};

struct Composition {
  std::vector<ChosenComponent> components; // in order of preference
  std::vector<script::Finding> findings;   // of plug-in names and options
  // What this build leaves out of what the settings ask for, a sentence each;
  // the application is right and works without.
  std::vector<std::string> notices;
};

// Every plug-in that is part of this program.
const std::vector<PluginFactory>& built_in_plugins();
const PluginFactory* find_plugin(std::string_view name);

Composition compose(const Settings& settings);
// The same with another table.
Composition compose(const Settings& settings,
                    const std::vector<PluginFactory>& plugins);

// The first chosen component of a role; null where there is none.
const ChosenComponent* first_of_role(const Composition& composition,
                                     std::string_view role);

} // namespace parlour::tools
