// unknown-module, unknown-command, unknown-event, unfilled-role and
// missing-parameter, judged by the table of roles; and unknown-act about what
// is said.
//
//   <post module="Telefone" …/>           did you mean 'Telephone'?
//   <post module="TTS" command="Say"/>    no such command of the role
//   <request module="Taxi" …/>            no component fills the role
#include <algorithm>

#include "runtime/message/roles.hpp"
#include "script/compiler/compilation.hpp"
#include "script/compiler/phrase_compiler.hpp"
#include "script/compiler/reaction_compiler.hpp"
#include "script/lint/passes.hpp"

namespace parlour::script::lint {

namespace {

// Examines messages and routes. A component that a script loads can fill any
// role later, so where one does (comes_later_) nothing is said about unfilled
// roles.
class MessageLint {
public:
  MessageLint(const LintContext& context, Findings& findings)
      : context_(context), findings_(findings),
        modules_(known_sources(context.program)) {
    const auto known = modules_.size();
    for (const auto& document : context.documents)
      add_names_made(document.root, modules_);
    comes_later_ = modules_.size() > known;
  }

  // Examines the element and everything inside of it.
  void look_at(const Element& element, const ElementRule& rule);

private:
  void message(const Element& element);
  void subscription(const Element& element);
  void said_act(const Element& element);
  void worded_act(const Element& element);
  bool is_said(const std::string& act) const;
  void route(const Element& element);
  void statement(const Element& element);
  bool is_missing(const std::string& name) const;
  bool never_comes(const Element& source) const;
  bool check_module(std::string name, Position position);
  bool check_agent(const Attribute& agent);
  void check_role(const std::string& name, Position position);
  bool is_filled(std::string_view role) const;
  void check_command(const std::string& module, const Attribute& command);
  void check_parameters(const Element& element, const std::string& module,
                        const Attribute& command);
  std::vector<std::string> roles_of(const std::string& module) const;
  std::vector<std::string> own_commands(const std::string& module) const;

  const LintContext& context_;
  Findings& findings_;
  std::vector<std::string> modules_;
  bool comes_later_ = false; // roles may be filled later
};

// A single file does not know the application's components, so there only a
// name that is similar to a known one is reported.
bool MessageLint::check_module(std::string name, Position position) {
  if (name.ends_with('*'))
    name.pop_back();
  if (name.empty() || is_computed(name) ||
      std::find(modules_.begin(), modules_.end(), name) != modules_.end())
    return true;
  const auto hint = did_you_mean(name, modules_);
  if (!hint.empty() || context_.settings)
    warn(findings_, "unknown-module", position,
         "no component, role or agent is called '" + name + "'" +
             (hint.empty() ? "; name a role such as ASR, or a component of "
                             "the settings"
                           : hint));
  return false;
}

// <send> names an agent of the settings, no role and no other component.
bool MessageLint::check_agent(const Attribute& agent) {
  std::vector<std::string> names;
  for (const auto& one : context_.program.settings.agents.agents)
    names.push_back(one.name);
  if (!context_.settings || is_computed(agent.value) ||
      std::ranges::count(names, agent.value) > 0)
    return true;
  const auto hint = did_you_mean(agent.value, names);
  warn(findings_, "unknown-module", agent.value_position,
       "no agent is called '" + agent.value + "'" +
           (hint.empty() ? "; name one in <agents> of the settings" : hint));
  return false;
}

std::vector<std::string>
MessageLint::roles_of(const std::string& module) const {
  if (find_role(module))
    return {module};
  const auto& known = context_.options.component_roles;
  const auto found = known.find(module);
  return found == known.end() ? std::vector<std::string>() : found->second;
}

// Whether any component of the settings fills the role.
bool MessageLint::is_filled(std::string_view role) const {
  const auto& known = context_.options.component_roles;
  return std::any_of(known.begin(), known.end(), [role](const auto& component) {
    const auto& roles = component.second;
    return std::any_of(roles.begin(), roles.end(), [role](const auto& one) {
      return canonical_role(one) == role;
    });
  });
}

// Whether certainly no component fills the role of this name.
bool MessageLint::is_missing(const std::string& name) const {
  const auto* role = find_role(name);
  return role && !role->reserved && !comes_later_ && context_.settings &&
         !context_.options.component_roles.empty() && !is_filled(role->name);
}

// Events of such a role never come, so reactions to them are skipped. An
// exception is ASR: typed input is an event of the recogniser.
bool MessageLint::never_comes(const Element& source) const {
  const auto name = source.is("on") ? source.value("source") : source.name;
  return canonical_role(name) != "ASR" && is_missing(name);
}

void MessageLint::check_role(const std::string& name, Position position) {
  if (!is_missing(name))
    return;
  const auto* role = find_role(name);
  warn(findings_, "unfilled-role", position,
       "no component fills the role '" + role->name + "', which " +
           role->sentence +
           ": the message is lost; name a plug-in for it in <Plugins> of the "
           "settings (parlour plugin list)");
}

// The additional commands of components with this name or role.
std::vector<std::string>
MessageLint::own_commands(const std::string& module) const {
  std::vector<std::string> commands;
  for (const auto& [component, own] : context_.options.component_commands) {
    const auto roles = roles_of(component);
    if (component == module || std::find(roles.begin(), roles.end(),
                                         canonical_role(module)) != roles.end())
      commands.insert(commands.end(), own.begin(), own.end());
  }
  return commands;
}

// A component may understand more than its roles say, so there again only a
// name that is similar to a known one is reported.
void MessageLint::check_command(const std::string& module,
                                const Attribute& command) {
  std::vector<std::string> commands;
  for (const auto& name : roles_of(module))
    if (const auto* role = find_role(name))
      for (const auto& one : role->commands)
        commands.push_back(one.name);
  for (const auto& own : own_commands(module))
    commands.push_back(own);
  const auto& name = command.value;
  if (commands.empty() || is_computed(name) ||
      std::find(commands.begin(), commands.end(), name) != commands.end())
    return;
  const auto hint = did_you_mean(name, commands);
  if (hint.empty() && !find_role(module))
    return;
  warn(
      findings_, "unknown-command", command.value_position,
      module + " has no command '" + name + "'" +
          (hint.empty() ? "; it understands " + alternatives(commands) : hint));
}

// <post>, <request> and <send>: the receiver, then its command, then the
// parameters.
void MessageLint::message(const Element& element) {
  const auto* module =
      element.attribute(element.is("send") ? "agent" : "module");
  const auto* command = element.attribute("command");
  if (!module || !check_module(module->value, module->value_position))
    return;
  check_role(module->value, module->value_position);
  if (!command)
    return;
  check_command(module->value, *command);
  check_parameters(element, module->value, *command);
}

// The number of required parameters in "number, who, text?".
std::size_t needed(const std::string& parameters) {
  const auto all = split_names(parameters);
  return static_cast<std::size_t>(
      std::ranges::count_if(all, [](const auto& one) {
        return !one.empty() && !one.ends_with('?');
      }));
}

// A <post> without parameters forwards those of the message being handled.
void MessageLint::check_parameters(const Element& element,
                                   const std::string& module,
                                   const Attribute& command) {
  const auto* role = find_role(module);
  const auto* known = role ? role->command(command.value) : nullptr;
  const auto* single = element.attribute("param");
  auto given = static_cast<std::size_t>(std::ranges::count_if(
      element.children, [](const auto& child) { return child.is("param"); }));
  if (!known || (element.is("post") && !single && given == 0))
    return;
  given += single && !single->value.empty();
  if (given == 0 && needed(known->parameters) > 0)
    warn(findings_, "missing-parameter", command.value_position,
         "'" + known->name + "' of " + role->name + " needs " +
             known->parameters +
             ", and this gives nothing; write a <param expr=\"…\"/> for each");
}

// <subscribe> and <unsubscribe>: the source, then its event.
void MessageLint::subscription(const Element& element) {
  const auto* source = element.attribute("source");
  const auto* event = element.attribute("command");
  if (!source || source->value == "*" ||
      !check_module(source->value, source->value_position))
    return;
  const auto* role = find_role(source->value);
  if (!role || !event || event->value == "*" || is_computed(event->value) ||
      role->event(event->value))
    return;
  warn(findings_, "unknown-event", event->value_position,
       source->value + " has no event '" + event->value + "'" +
           did_you_mean(event->value, names_of(role->events)));
}

// An act of <say> needs a phrase.
void MessageLint::said_act(const Element& element) {
  const auto& act = *element.attribute("act");
  std::vector<std::string> known;
  for (const auto& phrase : context_.program.phrases)
    known.push_back(phrase.act);
  if (!context_.settings || is_computed(act.value) ||
      std::ranges::count(known, act.value) != 0)
    return;
  const auto hint = did_you_mean(act.value, known);
  warn(findings_, "unknown-act", act.value_position,
       "no <phrase> has the act '" + act.value + "'" +
           (hint.empty() ? "; to say words by themselves write <speak "
                           "param=\"…\"/>"
                         : hint));
}

// An act of a <phrase> must be said by the engine or by a <say>. Similar names
// were reported when the phrase was compiled.
void MessageLint::worded_act(const Element& element) {
  const auto& act = *element.attribute("act");
  if (!context_.settings || is_said(act.value) ||
      !did_you_mean(act.value, say_acts()).empty())
    return;
  const auto begun = std::ranges::find_if(say_acts(), [&](const auto& known) {
    return act.value.starts_with(known) || known.starts_with(act.value);
  });
  warn(findings_, "unknown-act", act.value_position,
       "nothing says the act '" + act.value + "'" +
           (begun != say_acts().end()
                ? ", did you mean '" + *begun + "'?"
                : "; a script does by <say act=\"" + act.value + "\"/>"));
}

// Whether the engine says the act, or a script, which may compute it.
bool MessageLint::is_said(const std::string& act) const {
  bool said = std::ranges::count(say_acts(), act) > 0;
  walk(context_, true, [&](const Element& element, const ElementRule& rule) {
    if (is_statement(rule) && element.is("say"))
      said |= is_computed(element.value("act")) || element.value("act") == act;
  });
  return said;
}

// The sinks of a relay or filter, and the command under which they get it.
void MessageLint::route(const Element& element) {
  if (const auto* to = element.attribute("to"))
    for (const auto& name : split_names(to->value))
      if (check_module(name, to->value_position)) {
        check_role(name, to->value_position);
        if (const auto* as = element.attribute("as"))
          check_command(name, *as);
      }
}

// Which statements name a component, an event or an act.
void MessageLint::statement(const Element& element) {
  if (element.is("post") || element.is("request"))
    message(element);
  else if (element.is("send") && check_agent(*element.attribute("agent")))
    message(element);
  else if (element.is("unload"))
    check_module(element.value("name"),
                 element.attribute("name")->value_position);
  else if (element.is("subscribe") || element.is("unsubscribe"))
    subscription(element);
  else if (element.is("say") && element.attribute("act"))
    said_act(element);
}

// Reactions to events that never come are not examined.
void MessageLint::look_at(const Element& element, const ElementRule& rule) {
  if (is_statement(rule))
    statement(element);
  else if (element.is("relay") || element.is("filter"))
    route(element);
  else if (element.is("phrase"))
    worded_act(element);
  const bool holds_sources = std::find(rule.holds.begin(), rule.holds.end(),
                                       "sources") != rule.holds.end();
  for (const auto& child : element.children)
    if (const auto* inside = find_rule(child.name, rule.holds);
        inside && !(holds_sources && never_comes(child)))
      look_at(child, *inside);
}

} // namespace

void lint_messages(const LintContext& context, Findings& findings) {
  MessageLint lint(context, findings);
  for (const auto& document : context.documents)
    if (!document.platform)
      lint.look_at(document.root, rule_of(document.root));
  if (context.settings)
    lint.look_at(*context.settings, rule_of(*context.settings));
}

} // namespace parlour::script::lint
