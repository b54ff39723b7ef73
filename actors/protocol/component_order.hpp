// ComponentOrder: which plug-in to run, under which name and how. Settings and
// <load> both come down to one.
#pragma once

#include <string>

#include "runtime/base/component_policy.hpp"
#include "runtime/plugin/plugin.hpp"

namespace parlour::actors {

// A plug-in under the name of an instance.
// `factory.create` may be empty where only the options and the policy are kept
// (LoadingRules).
struct ComponentOrder {
  std::string name;
  PluginFactory factory;
  Options options;
  ComponentPolicy policy = {};

  // Whether the settings say the same of both. What makes the plug-in cannot be
  // compared: its name stands for it.
  bool same_as(const ComponentOrder& other) const {
    return name == other.name && options == other.options &&
           policy == other.policy &&
           factory.description.name == other.factory.description.name;
  }
};

} // namespace parlour::actors
