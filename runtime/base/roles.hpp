// Roles: the vocabulary of each kind of component, from one table, roles.def.
// `check`, requests, completion and the conformance tests of plug-ins read it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace parlour {

// What an event means to a request that waits for a reply.
enum class Reply : unsigned char {
  none,    // the request goes on waiting
  answer,  // ends it: `return` gets {command, params}
  refusal, // ends it with an error (kind Refused; Database for Database)
};

struct RoleCommand {
  std::string name;
  std::string parameters; // "text, context?"
  bool answered = false;  // always, by an event that ends the request
};

struct RoleEvent {
  std::string name;
  std::string parameters;
  Reply reply = Reply::none;
  bool routine = false; // nobody has to take it
};

struct Role {
  std::string name;
  std::string sentence;
  bool reserved = false; // a source that is no component
  std::vector<std::string> aliases;
  std::vector<RoleCommand> commands;
  std::vector<RoleEvent> events;

  // Null where the role has none of that name.
  const RoleCommand* command(std::string_view command_name) const;
  const RoleEvent* event(std::string_view event_name) const;
};

// In the table's order; the reserved sources last.
const std::vector<Role>& roles();

// By name or alias; null where there is none.
const Role* find_role(std::string_view name);

// Why a component, an agent or a socket cannot be called that, so that its
// messages pass for nobody else's; empty where it can. A sentence's end.
std::string wrong_source_name(std::string_view name);

// The role's own name for one of its aliases; other names as they are.
std::string_view canonical_role(std::string_view name);

} // namespace parlour
