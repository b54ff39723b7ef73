#include "tools/parlour/application/seat_events.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "runtime/message/roles.hpp"

namespace parlour::tools {

namespace {

using script::Severity;

void add_names(const std::vector<RoleEvent>& events,
               std::vector<std::string>& names) {
  for (const auto& event : events)
    names.push_back(event.name);
}

// Who fires the events of a name, and which.
struct Source {
  std::vector<std::string> events;
  bool is_known = false;  // a component, agent or role
  bool is_filled = false; // somebody is there to fire them
  bool may_fire_any = false;
};

// An agent is a process of its own: nobody knows what it fires beyond its
// roles.
void add_component(const ChosenComponent& component, Source& source) {
  source.is_known = source.is_filled = true;
  source.may_fire_any |= component.agent.has_value();
  const auto& description = component.factory.description;
  add_names(description.events, source.events);
  for (const auto& name : description.roles)
    if (const auto* role = find_role(name))
      add_names(role->events, source.events);
}

// A typed line is ASR's, and what the platform says comes from it: both need no
// component. What a plug-in that this build lacks would fire, nobody knows.
Source source_of(const std::string& name, const Settings& settings,
                 const Composition& composition) {
  Source source;
  source.is_known = source.is_filled = source.may_fire_any =
      std::ranges::count(settings.components, name, &ComponentSettings::name) &&
      !std::ranges::count(composition.components, name, &ChosenComponent::name);
  if (const auto* role = find_role(name)) {
    source.is_known = true;
    source.is_filled = role->reserved || role->name == "ASR";
    add_names(role->events, source.events);
  }
  for (const auto& component : composition.components)
    if (component.name == name || fills(component, canonical_role(name)))
      add_component(component, source);
  return source;
}

std::vector<std::string> known_names(const Composition& composition) {
  std::vector<std::string> names;
  for (const auto& role : roles())
    names.push_back(role.name);
  for (const auto& component : composition.components)
    names.push_back(component.name);
  return names;
}

std::optional<script::Finding> check(const script::Opening& opening,
                                     const SourceLocation& place,
                                     const Settings& settings,
                                     const Composition& composition) {
  const auto wrong = [&](std::string text) {
    return script::Finding{Severity::error, place, std::move(text)};
  };
  const auto source = source_of(opening.source, settings, composition);
  const auto& command = opening.command;
  if (!source.is_known)
    return wrong(fmt::format(
        "nothing can fire {}.{}: no component, role or agent is called '{}'{}",
        opening.source, command, opening.source,
        script::did_you_mean(opening.source, known_names(composition))));
  // Conversations raise the others, and where there is one none opens.
  if (const auto* role = find_role(opening.source);
      role && role->reserved && role->name != "System")
    return wrong(fmt::format("nothing can fire {}.{} at a seat where no "
                             "conversation is going on",
                             opening.source, command));
  if (command != "*" && !source.may_fire_any &&
      !std::ranges::count(source.events, command)) {
    const auto hint = script::did_you_mean(command, source.events);
    return wrong(fmt::format(
        "nothing can fire {}.{}{}", opening.source, command,
        !hint.empty()           ? hint
        : source.events.empty() ? std::string("; it has no events")
                                : fmt::format("; its events are {}",
                                              fmt::join(source.events, ", "))));
  }
  if (!source.is_filled)
    return script::Finding{
        Severity::warning, place,
        fmt::format("no component fills the role {}, so that {}.{} never comes "
                    "but where a run adds one (--voice)",
                    opening.source, opening.source, command),
        "unfilled-role"};
  return std::nullopt;
}

} // namespace

// An <open> of a script is checked by the compiler, like its other events.
std::vector<script::Finding> check_seat_events(const script::Program& program,
                                               const Composition& composition) {
  std::vector<script::Finding> findings;
  for (const auto& opening : program.openings) {
    const auto* seat = find_seat(program.settings.seats, opening.seat);
    const auto place = program.place(opening.position);
    if (!seat || seat->place.file != place.file)
      continue;
    if (auto finding = check(opening, place, program.settings, composition))
      findings.push_back(std::move(*finding));
  }
  return findings;
}

} // namespace parlour::tools
