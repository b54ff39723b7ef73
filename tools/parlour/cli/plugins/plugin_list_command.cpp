// `parlour plugin list`: describes every plug-in of the catalogue.
#include <ostream>

#include "tools/parlour/application/plugins/catalogue.hpp"
#include "tools/parlour/cli/plugins/plugin_commands.hpp"
#include "tools/parlour/console/exit_code.hpp"

namespace parlour::tools {

namespace {

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const auto& word : words)
    text += (text.empty() ? "" : ", ") + word;
  return text;
}

// "required", "else VALUE" or empty.
std::string default_of(const OptionDescription& option) {
  if (option.required)
    return "required";
  return option.fallback.empty() ? "" : "else " + option.fallback;
}

// The choices of an option, or the name of its type.
std::string takes(const OptionDescription& option) {
  return option.type == OptionType::choice ? joined(option.choices)
                                           : std::string(name_of(option.type));
}

// One plug-in: name, roles and origin; its options, commands and events.
void print(std::ostream& out, const PluginDescription& plugin,
           const std::string& where) {
  const auto roles =
      plugin.roles.empty() ? "" : " (" + joined(plugin.roles) + ')';
  out << plugin.name << roles << ", " << where << "\n  " << plugin.sentence
      << '\n';
  for (const auto& option : plugin.options) {
    const auto otherwise = default_of(option);
    out << "  " << option.name << ": " << takes(option)
        << (otherwise.empty() ? "" : ", ") << otherwise << "; "
        << option.sentence << '\n';
  }
  for (const auto& command : plugin.commands)
    out << "  understands " << command.name << '(' << command.parameters
        << ")\n";
  for (const auto& event : plugin.events)
    out << "  fires " << event.name << '(' << event.parameters << ")\n";
}

} // namespace

int plugin_list_command(const Places& places, const std::string& app,
                        const Console& console) {
  auto folder = places.working;
  if (!app.empty()) {
    const auto found = find_application(places, app);
    if (!found) {
      say_error(console, found.error().message);
      return exit_code::usage;
    }
    folder = *found;
  }
  Catalogue plugins(plugin_folders(places, folder));
  auto status = exit_code::success;
  // A file that cannot be loaded makes the exit status 1, but the list goes on.
  for (const auto& name : plugins.names()) {
    const auto file = plugins.file_of(name);
    if (const auto found = plugins.find(name)) {
      print(console.out, found->description,
            file.empty() ? "part of the program"
                         : shown_path(places, file.string()));
    } else {
      say_error(console, found.error().message);
      status = exit_code::wrong;
    }
  }
  return status;
}

} // namespace parlour::tools
