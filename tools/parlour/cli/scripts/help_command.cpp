// `parlour help NAME`. The texts come from tools/parlour/reference.
#include <algorithm>
#include <ostream>

#include "tools/parlour/cli/commands.hpp"
#include "tools/parlour/cli/component_page.hpp"
#include "tools/parlour/console/exit_code.hpp"
#include "tools/parlour/reference/pages.hpp"
#include "tools/parlour/reference/reference.hpp"

namespace parlour::tools {

int help_command(const HelpOptions& options,
                 const std::vector<std::string>& commands,
                 const Console& console) {
  if (!options.page.empty()) {
    console.out << (options.page == component_page_name
                        ? component_page()
                        : reference_page(options.page));
    return exit_code::success;
  }
  const auto text = reference_text(options.name, commands);
  if (!text) {
    say_error(console, text.error().message);
    return exit_code::usage;
  }
  console.out << *text;
  // A name that is both a command and a language element, such as "test".
  if (!entries_of(options.name).empty() &&
      std::ranges::count(commands, options.name) > 0)
    console.out << "\nOf the command: `parlour " << options.name
                << " --help`\n";
  return exit_code::success;
}

} // namespace parlour::tools
