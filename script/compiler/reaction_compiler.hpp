// Compiles reactions: the <messages> of handlers and states in both notations,
// and checks their sources and events by the table of roles (engine rule 1).
//
// Unknown sources and events are warnings only, because components may have
// events of their own and sources may appear at run time.
#pragma once

#include <vector>

#include "script/compiler/compilation.hpp"

namespace parlour::script {

// Compiles one <messages> element.
std::vector<Reaction> compile_messages(const Element& messages,
                                       const BodyContext& context,
                                       Compilation& compilation);

// The names of everything that can be a source of messages.
std::vector<std::string> known_sources(const Program& program);
// Adds the names of sockets and components that scripts below `root` create.
// Computed names are added as they are written, which does no harm.
void add_names_made(const Element& root, std::vector<std::string>& names);

// Adds the events that scripts below `root` raise; "*" for computed ones.
void add_events_raised(const Element& root, std::vector<std::string>& events);

// Spells a source and an event as the table of roles does. A name that the
// table lacks is a warning.
struct EventName {
  std::string source;
  std::string event;
};
EventName checked_event(EventName name, Position source, Position event,
                        Compilation& compilation);

} // namespace parlour::script
