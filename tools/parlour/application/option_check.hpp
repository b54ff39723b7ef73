// What a plug-in will not take of the options that it is given: one wording
// for settings and for the command line.
#pragma once

#include <string>
#include <vector>

#include "runtime/plugin/plugin.hpp"

namespace parlour::tools {

struct OptionMistake {
  std::string option;
  std::string text; // a sentence; `whose` stands first
  bool is_given = true;
};

// In the order of the description, then what it does not know.
std::vector<OptionMistake> option_mistakes(const std::string& whose,
                                           const PluginDescription& plugin,
                                           const Options& given);

} // namespace parlour::tools
