#include "runtime/plugin/description_check.hpp"

#include <set>

namespace parlour {

namespace {

void check_roles(const PluginDescription& plugin,
                 std::vector<std::string>& findings) {
  if (plugin.roles.empty() && plugin.commands.empty())
    findings.push_back("it is described without a role, and without commands "
                       "of its own");
  for (const auto& name : plugin.roles) {
    const auto* role = find_role(name);
    if (!role)
      findings.push_back("there is no role '" + name + "'");
    else if (role->reserved)
      findings.push_back("'" + name +
                         "' is no role, but a source that is "
                         "the platform's own");
  }
}

void check_options(const PluginDescription& plugin,
                   std::vector<std::string>& findings) {
  std::set<std::string> seen;
  for (const auto& option : plugin.options) {
    if (!seen.insert(option.name).second)
      findings.push_back("the option '" + option.name + "' is described twice");
    if (option.name.empty() || option.sentence.empty())
      findings.push_back("the option '" + option.name +
                         "' has no name or no sentence");
    if (const auto fits = check_option(option, option.fallback); !fits)
      findings.push_back("its default does not fit: " + fits.error().message);
  }
}

} // namespace

std::vector<std::string> check_description(const PluginDescription& plugin) {
  std::vector<std::string> findings;
  if (plugin.name.empty())
    findings.push_back("it is described without a name");
  else if (auto fault = wrong_source_name(plugin.name); !fault.empty())
    findings.push_back(std::move(fault));
  if (plugin.sentence.empty())
    findings.push_back("it is described without a sentence");
  if (plugin.is_inline && plugin.blocks)
    findings.push_back("is_inline says that it answers at once, and blocks "
                       "that it does not");
  check_roles(plugin, findings);
  check_options(plugin, findings);
  return findings;
}

} // namespace parlour
