#include "runtime/plugin/role_plugin.hpp"

#include <algorithm>
#include <cassert>

namespace parlour {

namespace {

const Role& known_role(std::string_view name) {
  const auto* role = find_role(name);
  assert(role && "no such role in roles.def");
  return *role;
}

} // namespace

RolePlugin::RolePlugin(std::string_view role) : role_(known_role(role)) {}

std::vector<std::string> RolePlugin::commands() const {
  std::vector<std::string> names;
  for (const auto& [name, handler] : handlers_)
    names.push_back(name);
  return names;
}

// A handler returns the index of the parameter that does not fit, if any.
void RolePlugin::on_message(const Message& message) {
  const auto found = handlers_.find(message.command);
  if (found == handlers_.end())
    on_other(message);
  else if (const auto wrong = found->second(message))
    refuse(complaint(message, *wrong));
}

void RolePlugin::on_other(const Message& message) {
  refuse(role_.name + " does not know the command '" + message.command + "'");
}

// The role's own refusal takes a reason, or a kind and a message; a role
// without a refusal has Failed.
void RolePlugin::refuse(const std::string& reason) {
  const auto said_no =
      std::ranges::find(role_.events, Reply::refusal, &RoleEvent::reply);
  if (said_no == role_.events.end())
    fire_event("Failed", {reason});
  else if (read_parameters(said_no->parameters).size() > 1)
    fire_event(said_no->name, {name_of(ErrorKind::refused), reason});
  else
    fire_event(said_no->name, {reason});
}

// "Speak takes a whole number as its parameter 2, 'utterance', not unknown".
std::string RolePlugin::complaint(const Message& message,
                                  std::size_t index) const {
  auto text = message.command + " takes ";
  const auto place = "its parameter " + std::to_string(index + 1);
  const auto* command = role_.command(message.command);
  const auto known =
      command ? read_parameters(command->parameters) : std::vector<Parameter>();
  if (index < known.size())
    text += std::string(sentence_of(known[index].kind)) + " as " + place +
            ", '" + known[index].name + "'";
  else
    text += "something else as " + place;
  if (index >= message.params.size())
    return text + ", which is missing";
  const auto& given = message.params[index];
  return text + ", not " +
         (given.if_string() ? "'" + given.text() + "'"
                            : std::string(name_of(given.type())));
}

} // namespace parlour
