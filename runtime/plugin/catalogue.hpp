// The plug-ins that can be had by name: those of the program, and those of the
// plug-in folder (engine rule 7.3).
#pragma once

#include <string>
#include <vector>

#include "runtime/base/error.hpp"
#include "runtime/plugin/plugin.hpp"

namespace parlour {

// Safe to use from any thread.
class PluginCatalogue {
public:
  virtual ~PluginCatalogue() = default;

  // The program's plug-in of that name, else the one of the file NAME.so in the
  // plug-in folder, as that file is now: a changed file is opened again, and
  // what came from the old one goes on beside it. What a factory and its
  // instances need stays mapped until the process ends. Errors are of kind
  // Settings and say what to do.
  virtual Expected<PluginFactory> find(const std::string& name) = 0;

  // All that can be found, the program's first, then by name.
  virtual std::vector<PluginDescription> all() = 0;
};

} // namespace parlour
