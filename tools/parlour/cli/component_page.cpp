#include "tools/parlour/cli/component_page.hpp"

#include "tools/parlour/application/plugins/catalogue.hpp"
#include "tools/parlour/reference/entry_page.hpp"
#include "tools/parlour/reference/pages.hpp"

namespace parlour::tools {

namespace {

// "a whole number, else 175; words a minute"
std::string words_of(const OptionDescription& option) {
  auto words = option.type == OptionType::choice
                   ? listed(option.choices)
                   : std::string(name_of(option.type));
  if (option.required)
    words += ", required";
  else if (!option.fallback.empty())
    words += ", else " + option.fallback;
  return words + "; " + option.sentence;
}

Entry entry_of(const PluginDescription& plugin) {
  Entry entry{plugin.name, plugin.name, plugin.sentence};
  if (!plugin.roles.empty())
    entry.facts.push_back({"role", listed(plugin.roles)});
  for (const auto& option : plugin.options)
    entry.details.push_back({"option", option.name, words_of(option)});
  for (const auto& command : plugin.commands)
    entry.details.push_back(
        {"understands", command.name + "(" + command.parameters + ")", ""});
  for (const auto& event : plugin.events)
    entry.details.push_back(
        {"fires", event.name + "(" + event.parameters + ")", ""});
  return entry;
}

} // namespace

std::vector<std::string> help_pages() {
  auto pages = reference_pages();
  pages.emplace_back(component_page_name);
  return pages;
}

std::string component_page() {
  std::string text =
      "# Components\n\nThe components that are part of the program, and their "
      "options (`<option>` of a `<component>`).\nWhat they understand and fire "
      "is in [Roles](roles.md); here is what they have beyond that.\nIt is "
      "printed by `parlour help --page components`.\n";
  for (const auto& plugin : built_in_plugins())
    text += '\n' + entry_section(entry_of(plugin.description));
  return text;
}

} // namespace parlour::tools
