// Chooses and checks the plug-ins that the settings name.
#include "tools/parlour/application/plugins/composition.hpp"

#include <algorithm>
#include <utility>

#include "runtime/base/call_deadline.hpp"
#include "runtime/plugin/component_check.hpp"
#include "runtime/plugin/scope_check.hpp"
#include "tools/parlour/application/plugins/option_check.hpp"
#include "tools/parlour/application/plugins/process_isolation.hpp"
#include "tools/parlour/application/plugins/shipped_plugin.hpp"

namespace parlour::tools {

namespace {

using script::Severity;

// How a finding names a component: by its plug-in, and by its own name if that
// differs.
std::string whose(const ComponentSettings& component) {
  return component.name == component.plugin
             ? component.plugin
             : component.name + ": " + component.plugin;
}

// Reports wrong, missing and unknown options at their place in the settings,
// or at the component if that is not known.
void check_options(const ComponentSettings& component,
                   const PluginDescription& plugin, const OptionPlaces& places,
                   Composition& composition) {
  for (auto& mistake :
       option_mistakes(whose(component), plugin, component.options)) {
    const auto place = mistake.is_given && places
                           ? places(component.name, mistake.option)
                           : std::nullopt;
    composition.findings.push_back({Severity::error,
                                    place.value_or(component.place),
                                    std::move(mistake.text)});
  }
}

// Whether the plug-in can have the scope that the settings give it.
void check_scope(const ComponentSettings& component,
                 const PluginDescription& plugin, Composition& composition) {
  if (auto fits = check_scope(component.policy.scope, plugin); !fits)
    composition.findings.push_back(
        {Severity::error, component.place,
         whose(component) + ": " + fits.error().message});
}

// A deadline of its own must take effect, and must end a call before the
// request that waits for it ends.
void check_deadline(const ComponentSettings& component,
                    const PluginDescription& plugin,
                    const SessionSettings& sessions, Composition& composition) {
  const auto& scope = component.policy.scope;
  const auto& deadline = component.policy.deadline;
  const bool in_turn = plugin.is_inline && (scope.kind == Scope::Kind::usual ||
                                            scope.kind == Scope::Kind::in_turn);
  if (!deadline)
    return;
  // A component called in the session's own turn has no deadline.
  if (in_turn)
    composition.findings.push_back(
        {Severity::error, component.place,
         whose(component) +
             ": it is asked in the conversation's own turn, where nobody can "
             "give up a call that hangs; for a deadline, say scope=\"node\""});
  else if (*deadline >= sessions.request_timeout)
    composition.findings.push_back(
        {Severity::warning, component.place,
         whose(component) +
             ": its deadline is not shorter than request-timeout: a request "
             "ends before the component is given up",
         "long-deadline"});
}

// Adds components to a composition, one after the other.
// The order is that of preference for a role: agents, then the settings'
// components in file order.
class Composer {
public:
  Composer(const Settings& settings, Catalogue& plugins,
           const OptionPlaces& places)
      : settings_(settings), plugins_(plugins), places_(places) {}

  Composition compose() {
    for (const auto& agent : settings_.agents.agents)
      add_agent(agent);
    for (const auto& component : settings_.components)
      if (!is_missing(component.plugin))
        add(component);
    return std::move(composition_);
  }

private:
  // That this build lacks it is no mistake of the application.
  bool is_missing(const std::string& name) {
    const auto without = shipped_plugin(name).without;
    if (without.empty() || plugins_.has(name))
      return false;
    composition_.notices.push_back(
        name + " is not available in this build: " + std::string(without));
    return true;
  }

  // Null: the plug-in cannot be found.
  ChosenComponent* add(const ComponentSettings& component);
  void add_agent(const AgentSettings& agent);
  void check_roles(const AgentSettings& agent, const ChosenComponent& chosen);
  void error(const SourceLocation& place, std::string text) {
    composition_.findings.push_back({Severity::error, place, std::move(text)});
  }

  const Settings& settings_;
  Catalogue& plugins_;
  const OptionPlaces& places_;
  Composition composition_;
};

ChosenComponent* Composer::add(const ComponentSettings& component) {
  auto factory = plugins_.find(component.plugin);
  if (!factory) {
    error(component.place, factory.error().message);
    return nullptr;
  }
  complete_description(factory->description, component.options,
                       settings_.folder);
  // The effective policy, with the default deadline worked out.
  auto policy = component.policy;
  policy.deadline = call_deadline(policy, settings_.sessions.request_timeout);
  // From here on the plug-in is checked as it will run: one from a file is no
  // longer inline, for example.
  *factory =
      hosted(std::move(*factory), policy, plugins_.file_of(component.plugin));
  if (auto right = check_component(component.name, factory->description);
      !right)
    error(component.place, right.error().message);
  check_options(component, factory->description, places_, composition_);
  check_scope(component, factory->description, composition_);
  check_deadline(component, factory->description, settings_.sessions,
                 composition_);
  composition_.components.push_back({component.name, std::move(*factory),
                                     component.options, component.place,
                                     policy});
  return &composition_.components.back();
}

// To the rest of the program an agent is its stand-in, with the agent's roles.
// Without a stand-in it is an agent that never connects.
void Composer::add_agent(const AgentSettings& agent) {
  adapters::agents::RemoteAgentOrder order{agent.name, agent.roles,
                                           settings_.sessions.request_timeout};
  if (agent.stand_in.empty()) {
    composition_.components.push_back(
        {agent.name,
         adapters::agents::remote_agent(order, nullptr),
         {},
         agent.place,
         {},
         order});
    if (!agent.options.empty())
      error(agent.place, agent.name + ": options are those of a stand-in, "
                                      "and the agent has none");
    return;
  }
  auto* chosen = add({agent.name, agent.stand_in, agent.options, agent.place});
  if (!chosen)
    return;
  check_roles(agent, *chosen);
  auto& roles = chosen->factory.description.roles;
  if (order.roles.empty())
    order.roles = roles;
  roles = order.roles;
  chosen->agent = std::move(order);
}

void Composer::check_roles(const AgentSettings& agent,
                           const ChosenComponent& chosen) {
  const auto& able = chosen.factory.description.roles;
  for (const auto& role : agent.roles)
    if (!std::ranges::count(able, role))
      error(agent.place, agent.name + ": its stand-in " + agent.stand_in +
                             " cannot fill the role " + role);
}

} // namespace

Composition compose(const Settings& settings, Catalogue& plugins,
                    const OptionPlaces& places) {
  return Composer(settings, plugins, places).compose();
}

bool fills(const ChosenComponent& component, std::string_view role) {
  return std::ranges::count(component.factory.description.roles, role) > 0;
}

const ChosenComponent* first_of_role(const Composition& composition,
                                     std::string_view role) {
  for (const auto& component : composition.components) {
    if (component.policy.scope.instances == 0)
      continue; // not before it is loaded
    if (fills(component, role))
      return &component;
  }
  return nullptr;
}

std::map<std::string, std::vector<std::string>>
roles_by_component(const Composition& composition) {
  std::map<std::string, std::vector<std::string>> all;
  for (const auto& component : composition.components)
    all[component.name] = component.factory.description.roles;
  return all;
}

std::set<std::string, std::less<>> names_of_role(const Composition& composition,
                                                 std::string_view role) {
  std::set<std::string, std::less<>> names;
  for (const auto& component : composition.components)
    if (fills(component, role))
      names.insert(component.name);
  return names;
}

} // namespace parlour::tools
