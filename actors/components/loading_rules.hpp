// LoadingRules: what a component must be to be loaded, and what the settings
// say of one that is loaded by its name. Decides without an actor; lives on the
// supervisor's thread.
#pragma once

#include <map>
#include <string>

#include "actors/components/deployment.hpp"
#include "actors/components/supervision_parts.hpp"

namespace parlour::actors {

// A component comes from the settings with all that they say of it; `<load
// plugin="X"/>` gives a name only, so the options and the policy that belong to
// this name are kept here.
class LoadingRules {
public:
  LoadingRules(const ComponentSettings& settings,
               const Deployments& deployments)
      : settings_(settings), deployments_(deployments) {}

  // What the settings say of a component counts when it is loaded again, too.
  void remember(const ComponentOrder& order);
  // For a plug-in and the component's name, which may be empty: the plug-in's.
  Expected<ComponentOrder> order_for(const std::string& plugin,
                                     const std::string& name) const;
  // An error says why it may not be loaded now.
  Expected<void> check(const ComponentOrder& order) const;
  // That there is none of this name, with the one that is meant perhaps.
  Error nobody_called(const std::string& name) const;

private:
  Expected<void> check_options(const ComponentOrder& order) const;

  const ComponentSettings& settings_;
  const Deployments& deployments_;
  std::map<std::string, ComponentOrder> known_; // by name; without factories
};

} // namespace parlour::actors
