#include <ostream>

#include "runtime/base/roles.hpp"
#include "tools/parlour/cli/plugin_commands.hpp"
#include "tools/parlour/console/exit_code.hpp"
#include "tools/parlour/plugin_template/plugin_skeleton.hpp"

namespace parlour::tools {

namespace {

const char* meaning(Reply reply) {
  switch (reply) {
  case Reply::answer:
    return "; ends a request";
  case Reply::refusal:
    return "; ends a request with an error";
  case Reply::none:
    break;
  }
  return "";
}

void print(std::ostream& out, const Role& role) {
  out << role.name;
  for (const auto& alias : role.aliases)
    out << ", " << alias;
  out << ": " << role.sentence << '\n';
  for (const auto& command : role.commands)
    out << "  understands " << command.name << '(' << command.parameters << ')'
        << (command.answered ? "; always answered" : "") << '\n';
  for (const auto& event : role.events)
    out << "  fires " << event.name << '(' << event.parameters << ')'
        << meaning(event.reply) << '\n';
}

} // namespace

int plugin_roles_command(const std::string& name, const Console& console) {
  if (!name.empty()) {
    const auto role = component_role(name);
    if (!role) {
      say_error(console, role.error().message);
      return exit_code::usage;
    }
    print(console.out, **role);
    return exit_code::well;
  }
  for (const auto& role : roles())
    if (!role.reserved)
      console.out << role.name << ": " << role.sentence << '\n';
  return exit_code::well;
}

} // namespace parlour::tools
