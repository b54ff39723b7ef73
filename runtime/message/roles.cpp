// The table of roles as data. The macros below turn each line of roles.def into
// a statement that extends the role that was added last.

#include "runtime/message/roles.hpp"

#include <algorithm>
#include <cctype>

namespace parlour {

namespace {

template <class T>
const T* find_named(const std::vector<T>& all, std::string_view name) {
  auto found = std::find_if(all.begin(), all.end(),
                            [&](const T& one) { return one.name == name; });
  return found == all.end() ? nullptr : &*found;
}

// The table is read once, at first use.
std::vector<Role> read_table() {
  std::vector<Role> all;
  auto add_role = [&](const char* name, const char* sentence, bool reserved) {
    all.push_back({name, sentence, reserved, {}, {}, {}});
  };
  auto add_event = [&](const char* name, const char* parameters, Reply reply) {
    all.back().events.push_back({name, parameters, reply});
  };
  auto mark_routine = [&](std::string_view name) {
    for (auto& event : all.back().events)
      event.routine |= event.name == name;
  };
#define ROLE(name, sentence) add_role(#name, sentence, false);
#define RESERVED(name, sentence) add_role(#name, sentence, true);
#define ALIAS(name) all.back().aliases.push_back(#name);
#define COMMAND(name, parameters)                                              \
  all.back().commands.push_back({#name, parameters, false});
#define REQUEST(name, parameters)                                              \
  all.back().commands.push_back({#name, parameters, true});
#define EVENT(name, parameters) add_event(#name, parameters, Reply::none);
#define REPLY(name, parameters) add_event(#name, parameters, Reply::answer);
#define REFUSAL(name, parameters) add_event(#name, parameters, Reply::refusal);
#define ROUTINE(name) mark_routine(#name);
#include "runtime/message/roles.def"
#undef ROLE
#undef RESERVED
#undef ALIAS
#undef COMMAND
#undef REQUEST
#undef EVENT
#undef REPLY
#undef REFUSAL
#undef ROUTINE
  return all;
}

// Whether this is the name of the role or one of its aliases.
bool is_called(const Role& role, std::string_view name) {
  return role.name == name ||
         std::find(role.aliases.begin(), role.aliases.end(), name) !=
             role.aliases.end();
}

} // namespace

const RoleCommand* Role::command(std::string_view command_name) const {
  return find_named(commands, command_name);
}

const RoleEvent* Role::event(std::string_view event_name) const {
  return find_named(events, event_name);
}

const std::vector<Role>& roles() {
  static const std::vector<Role> all = read_table();
  return all;
}

// Linear: there are few roles.
const Role* find_role(std::string_view name) {
  for (const auto& role : roles())
    if (is_called(role, name))
      return &role;
  return nullptr;
}

namespace {

bool is_letter(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) || c == '_' ||
         static_cast<unsigned char>(c) >= 0x80;
}

// Whether <messages> can have an element of this name.
bool is_name(std::string_view text) {
  return is_letter(text.front()) &&
         std::all_of(text.begin(), text.end(), [](char c) {
           return is_letter(c) || c == '-' ||
                  std::isdigit(static_cast<unsigned char>(c));
         });
}

} // namespace

// The form is checked first, then whether the name is taken by a role.
std::string wrong_source_name(std::string_view name) {
  const auto quoted = "'" + std::string(name) + "'";
  if (name.empty())
    return "a name is missing";
  if (!is_name(name))
    return quoted + " is no name: it begins with a letter or _, and has "
                    "letters, digits, _ and - only";
  const auto* role = find_role(name);
  if (!role)
    return {};
  return quoted +
         (role->reserved ? " is a source of the platform's own"
                         : " is the name of a role, and stands for whoever "
                           "fills it") +
         "; choose another name";
}

std::string_view canonical_role(std::string_view name) {
  const auto* role = find_role(name);
  return role ? std::string_view(role->name) : name;
}

} // namespace parlour
