// What an application's settings chose of the plug-ins, with which options
// (architecture rule 7).
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/base/settings.hpp"
#include "runtime/plugin/plugin.hpp"
#include "script/source/findings.hpp"
#include "tools/parlour/application/catalogue.hpp"

namespace parlour::tools {

// One component instance that the settings ask for.
struct ChosenComponent {
  std::string name;
  PluginFactory factory;
  Options options;
  Place place; // in the settings
  Upkeep upkeep = {};
};

struct Composition {
  std::vector<ChosenComponent> components; // in order of preference
  std::vector<script::Finding> findings;   // of plug-in names and options
  // What this build leaves out of what the settings ask for, a sentence each;
  // the application is right and works without.
  std::vector<std::string> notices;
};

// Where the settings give a component an option; nothing where that is not
// known. Asked for mistakes only, whose place is otherwise the component's.
using OptionPlaces = std::function<std::optional<Place>(
    const std::string& component, const std::string& option)>;

Composition compose(const Settings& settings, Catalogue& plugins,
                    const OptionPlaces& places = {});

// The first chosen component of a role; null where there is none.
const ChosenComponent* first_of_role(const Composition& composition,
                                     std::string_view role);

} // namespace parlour::tools
