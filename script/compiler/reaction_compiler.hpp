// Reactions: <messages> of handlers and states, in both of their forms, and
// what the roles table knows of their sources and events (engine rule 1).
#pragma once

#include <vector>

#include "script/compiler/compilation.hpp"

namespace parlour::script {

// The reactions of one <messages>.
std::vector<Reaction> compile_messages(const Element& messages,
                                       const BodyContext& context,
                                       Compilation& compilation);

// The names of everything that can be a source of messages.
std::vector<std::string> known_sources(const Program& program,
                                       const std::vector<std::string>& agents);
// The sockets that scripts below `root` open and the components that they load;
// a computed name helps nobody.
void add_names_made(const Element& root, std::vector<std::string>& names);

// The events that scripts below `root` raise; "*" for computed ones.
void add_events_raised(const Element& root, std::vector<std::string>& events);

// A source and an event as the roles table spells them; what it does not know
// is a warning.
struct EventName {
  std::string source;
  std::string event;
};
EventName checked_event(EventName name, Position source, Position event,
                        Compilation& compilation);

} // namespace parlour::script
