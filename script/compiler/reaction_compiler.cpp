// Compiles both notations of a reaction:
//
//   <messages>
//     <component><ASR><Rejected>…</Rejected></ASR></component>
//     <on source="ASR" event="*">…</on>
//   </messages>

#include "script/compiler/reaction_compiler.hpp"

#include <algorithm>

#include "runtime/message/roles.hpp"
#include "script/xml/element_table.hpp"

namespace parlour::script {

namespace {

// The candidate that equals the name except for the case of its first letter.
std::string spelt_as(const std::string& name,
                     const std::vector<std::string>& candidates) {
  if (std::find(candidates.begin(), candidates.end(), name) != candidates.end())
    return name;
  for (const auto& candidate : candidates)
    if (same_name(candidate, name))
      return candidate;
  return {};
}

// A file that is checked alone does not know the application's components, so
// there only a name that is similar to a known one is reported.
void warn_of_source(const std::string& name, Position position,
                    Compilation& compilation) {
  auto hint = did_you_mean(name, compilation.sources);
  if (!hint.empty() || !compilation.program.single_file)
    compilation.findings.add(
        {Severity::warning,
         {position},
         "no component, role, agent or socket is called '" + name + "'" + hint,
         "unknown-module"});
}

// The source as the table spells it, after a warning if it is unknown.
std::string checked_source(const std::string& name, Position position,
                           Compilation& compilation) {
  if (name == "*")
    return name;
  auto found = spelt_as(name, compilation.sources);
  if (!found.empty())
    return found;
  warn_of_source(name, position, compilation);
  return name;
}

// The events of the role and, for Script, those that scripts raise.
std::vector<std::string> events_of(const Role& role,
                                   const Compilation& compilation) {
  auto events = names_of(role.events);
  if (role.name == "Script")
    events.insert(events.end(), compilation.raised.begin(),
                  compilation.raised.end());
  return events;
}

// Events of Script are raised by scripts. Nothing is said if that script may be
// in another file, or if a raised name is computed.
void warn_of_event(const EventName& name, Position position,
                   const std::vector<std::string>& events,
                   Compilation& compilation) {
  const auto hint = did_you_mean(name.event, events);
  const bool is_raised = canonical_role(name.source) == "Script";
  const bool may_be_raised =
      compilation.program.single_file ||
      std::find(events.begin(), events.end(), "*") != events.end();
  if (is_raised && may_be_raised && hint.empty())
    return;
  compilation.findings.add(
      {Severity::warning,
       {position},
       is_raised
           ? "nothing raises the event '" + name.event + "'" +
                 (hint.empty() ? "; <fire event=\"" + name.event + "\"/> does"
                               : hint)
           : name.source + " has no event '" + name.event + "'" +
                 (hint.empty() ? "; it has " + alternatives(events) : hint),
       "unknown-event"});
}

// Both notations: <component><Source><Event>, and <on source event> for names
// that cannot be element names.
class MessagesCompiler {
public:
  MessagesCompiler(const BodyContext& context, Compilation& compilation)
      : context_(context), compilation_(compilation) {
    context_.handles_message = true;
  }

  void compile(const Element& messages) {
    for (const auto& child : messages.children) {
      if (child.is("on"))
        compile_on(child);
      else
        compile_sources(child);
    }
  }
  std::vector<Reaction> take() {
    return std::move(reactions_);
  }

private:
  // <component>: an element for each source, which holds one for each event.
  void compile_sources(const Element& component) {
    for (const auto& source : component.children) {
      if (source.is("on"))
        compile_on(source);
      else
        for (const auto& event : source.children)
          add({source.name, event.name}, source.position, event.position,
              event);
    }
  }
  // <on source="…" event="…">.
  void compile_on(const Element& on) {
    const auto& source = *on.attribute("source");
    const auto& event = *on.attribute("event");
    add({source.value, event.value}, source.value_position,
        event.value_position, on);
  }
  void add(EventName name, Position source, Position event,
           const Element& body) {
    name = checked_event(std::move(name), source, event, compilation_);
    check_first(name, event);
    auto inside = context_;
    inside.name += " " + name.source + "." + name.event;
    reactions_.push_back({name.source, name.event,
                          compilation_.bodies.body(body, inside),
                          body.position});
  }

  // An event can have one reaction here only.
  void check_first(const EventName& name, Position event) {
    for (const auto& reaction : reactions_)
      if (reaction.source == name.source && reaction.event == name.event)
        return compilation_.findings.error(
            event, "a second reaction to " + name.source + "." + name.event +
                       ", after the one in line " +
                       std::to_string(reaction.position.line) +
                       "; put both into one");
  }

  BodyContext context_;
  Compilation& compilation_;
  std::vector<Reaction> reactions_;
};

} // namespace

std::vector<Reaction> compile_messages(const Element& messages,
                                       const BodyContext& context,
                                       Compilation& compilation) {
  MessagesCompiler compiler(context, compilation);
  compiler.compile(messages);
  return compiler.take();
}

// Remote agents, roles with their aliases, components and their plug-ins.
std::vector<std::string> known_sources(const Program& program) {
  std::vector<std::string> names;
  for (const auto& agent : program.settings.agents.agents)
    names.push_back(agent.name);
  for (const auto& role : roles()) {
    names.push_back(role.name);
    names.insert(names.end(), role.aliases.begin(), role.aliases.end());
  }
  for (const auto& component : program.settings.components) {
    names.push_back(component.name);
    names.push_back(component.plugin);
  }
  return names;
}

void add_names_made(const Element& root, std::vector<std::string>& names) {
  for (const auto& child : root.children) {
    if (child.is("socket"))
      names.push_back(child.value("name"));
    if (child.is("load"))
      names.push_back(child.value(child.attribute("name") ? "name" : "plugin"));
    add_names_made(child, names);
  }
}

void add_events_raised(const Element& root, std::vector<std::string>& events) {
  for (const auto& child : root.children) {
    if (child.is("fire") && child.attribute("event"))
      events.push_back(child.value("event").find('{') == std::string::npos
                           ? child.value("event")
                           : "*");
    add_events_raised(child, events);
  }
}

// Events of components without a role cannot be checked.
EventName checked_event(EventName name, Position source, Position event,
                        Compilation& compilation) {
  name.source = checked_source(name.source, source, compilation);
  const auto* role = find_role(name.source);
  if (!role || name.event == "*")
    return name;
  const auto events = events_of(*role, compilation);
  const auto found = spelt_as(name.event, events);
  if (found.empty())
    warn_of_event(name, event, events, compilation);
  else
    name.event = found;
  return name;
}

} // namespace parlour::script
