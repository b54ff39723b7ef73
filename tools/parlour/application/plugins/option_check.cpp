// Compares given options with their descriptions (runtime/plugin).
#include "tools/parlour/application/plugins/option_check.hpp"

#include <algorithm>

#include "script/source/findings.hpp"

namespace parlour::tools {

std::vector<OptionMistake> option_mistakes(const std::string& whose,
                                           const PluginDescription& plugin,
                                           const Options& given) {
  std::vector<OptionMistake> mistakes;
  std::vector<std::string> known;
  for (const auto& option : plugin.options) {
    known.push_back(option.name);
    // A missing option is a mistake only if the plug-in requires it.
    const auto value = given.find(option.name);
    if (value == given.end()) {
      if (option.required)
        mistakes.push_back({option.name,
                            whose + ": the option '" + option.name +
                                "' is missing: " + option.sentence,
                            false});
    } else if (const auto fits = check_option(option, value->second); !fits) {
      mistakes.push_back({option.name, whose + ": " + fits.error().message});
    }
  }
  for (const auto& [name, value] : given)
    if (std::ranges::find(known, name) == known.end())
      mistakes.push_back({name, whose + " has no option '" + name + "'" +
                                    script::did_you_mean(name, known)});
  return mistakes;
}

} // namespace parlour::tools
