// `parlour plugin roles`: prints the table of roles
// (runtime/message/roles.def).
#include <ostream>

#include "runtime/message/roles.hpp"
#include "tools/parlour/cli/plugins/plugin_commands.hpp"
#include "tools/parlour/console/exit_code.hpp"
#include "tools/parlour/plugin_template/plugin_skeleton.hpp"
#include "tools/parlour/reference/entry_text.hpp"
#include "tools/parlour/reference/role_entry.hpp"

namespace parlour::tools {

int plugin_roles_command(const std::string& name, const Console& console) {
  if (!name.empty()) {
    const auto role = component_role(name);
    if (!role) {
      say_error(console, role.error().message);
      return exit_code::usage;
    }
    console.out << entry_text(role_entry(**role));
    return exit_code::success;
  }
  // Reserved sources such as Session are no roles of components.
  for (const auto& role : roles())
    if (!role.reserved)
      console.out << role.name << ": " << role.sentence << '\n';
  return exit_code::success;
}

} // namespace parlour::tools
