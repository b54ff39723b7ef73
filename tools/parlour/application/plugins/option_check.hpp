// Checks options against a plug-in's description. Settings and the command line
// use it, so a mistake has the same wording in both.
#pragma once

#include <string>
#include <vector>

#include "runtime/plugin/plugin.hpp"

namespace parlour::tools {

struct OptionMistake {
  std::string option;
  std::string text;     // a sentence that begins with `whose`
  bool is_given = true; // false: it is missing
};

// First the options of the description, in its order (missing, or with a wrong
// value), then unknown ones. Empty if all options are correct. `whose` names
// the component or plug-in.
std::vector<OptionMistake> option_mistakes(const std::string& whose,
                                           const PluginDescription& plugin,
                                           const Options& given);

} // namespace parlour::tools
