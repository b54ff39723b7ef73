// The plug-ins that are available by name: those of the program and those in
// the plug-in folder (engine rule 7.3).
#pragma once

#include <string>
#include <vector>

#include "runtime/base/error.hpp"
#include "runtime/plugin/plugin.hpp"

namespace parlour {

// Implemented by tools/parlour/application/plugins/catalogue. Safe to use from
// any thread.
class PluginCatalogue {
public:
  virtual ~PluginCatalogue() = default;

  // Finds a plug-in of the program by name, else loads NAME.so from the plug-in
  // folder. A file that has changed is loaded again; instances of the old file
  // go on beside the new ones. A library stays mapped until the process ends,
  // so factories and instances never outlive their code. Errors are of kind
  // Settings and say what to do.
  virtual Expected<PluginFactory> find(const std::string& name) = 0;

  // Descriptions of all plug-ins that can be found: the program's first, then
  // the folder's by name.
  virtual std::vector<PluginDescription> all() = 0;
};

} // namespace parlour
