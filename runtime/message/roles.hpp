// Roles: the vocabulary of each kind of component, read from roles.def.
// `parlour check`, requests, completion in editors and the conformance test use
// it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace parlour {

// What an event means to a request that waits for a reply.
enum class Reply : unsigned char {
  none,    // the request keeps waiting
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
  bool routine = false; // nothing is wrong if nobody takes it
};

// Immutable; the table owns all roles for the lifetime of the process.
struct Role {
  std::string name;
  std::string sentence;
  bool reserved = false; // a source of the platform, not a component
  std::vector<std::string> aliases;
  std::vector<RoleCommand> commands;
  std::vector<RoleEvent> events;

  // Return null if the role has no command or event of that name.
  const RoleCommand* command(std::string_view command_name) const;
  const RoleEvent* event(std::string_view event_name) const;
};

// In the order of the table; the reserved sources come last. Safe from any
// thread.
const std::vector<Role>& roles();

// Finds a role by its name or an alias; null if there is none.
const Role* find_role(std::string_view name);

// Why a component, agent or socket cannot have this name; empty if it can. A
// name of a role or of the platform would make its messages look like theirs
// (engine rule 1.5). The text is the end of a sentence.
std::string wrong_source_name(std::string_view name);

// The name of the role that has this alias; any other name unchanged.
std::string_view canonical_role(std::string_view name);

} // namespace parlour
