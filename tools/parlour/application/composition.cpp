#include "tools/parlour/application/composition.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "runtime/base/call_deadline.hpp"
#include "runtime/plugin/component_check.hpp"
#include "runtime/plugin/scope_check.hpp"
#include "tools/parlour/application/hosting.hpp"
#include "tools/parlour/application/option_check.hpp"

namespace parlour::tools {

namespace {

using script::Severity;

// Plug-ins of a voice seat that this program does not have, and what happens
// instead: an application that asks for them runs with text.
const std::map<std::string, std::string>& voice_plugins() {
  static const std::map<std::string, std::string> table = {
      {"AlsaMicrophone", "turns are typed instead of spoken"},
      {"AlsaSpeaker", "text is shown instead of played"},
      {"ESpeakTTS", "text is shown instead of spoken"},
      {"PocketSphinxASR", "turns are typed instead of spoken"},
      {"SpeexEnhancement", "there is no audio to clean"},
  };
  return table;
}

// Whom a finding is about: the plug-in, where need be of which component.
std::string whose(const ComponentSettings& component) {
  return component.name == component.plugin
             ? component.plugin
             : component.name + ": " + component.plugin;
}

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

void check_scope(const ComponentSettings& component,
                 const PluginDescription& plugin, Composition& composition) {
  if (auto fits = check_scope(component.upkeep.scope, plugin); !fits)
    composition.findings.push_back(
        {Severity::error, component.place,
         whose(component) + ": " + fits.error().message});
}

// A deadline has to be one that is kept, and in time for whoever waits.
void check_deadline(const ComponentSettings& component,
                    const PluginDescription& plugin,
                    const SessionSettings& sessions, Composition& composition) {
  const auto& [scope, deadline, host] = component.upkeep;
  const bool in_turn = plugin.is_inline && (scope.kind == Scope::Kind::usual ||
                                            scope.kind == Scope::Kind::in_turn);
  if (deadline == defaults::component_deadline)
    return; // not said
  if (in_turn)
    composition.findings.push_back(
        {Severity::error, component.place,
         whose(component) +
             ": it is asked in the conversation's own turn, where nobody can "
             "give up a call that hangs; for a deadline, say scope=\"node\""});
  else if (deadline >= sessions.request_timeout)
    composition.findings.push_back(
        {Severity::warning, component.place,
         whose(component) +
             ": its deadline is not shorter than request-timeout: a request "
             "ends before the component is given up",
         "long-deadline"});
}

} // namespace

Composition compose(const Settings& settings, Catalogue& plugins,
                    const OptionPlaces& places) {
  Composition composition;
  for (const auto& component : settings.components) {
    const auto& name = component.plugin;
    const auto voice = voice_plugins().find(name);
    if (voice != voice_plugins().end() && !plugins.has(name)) {
      composition.notices.push_back(
          name + " is not available in this build: " + voice->second);
      continue;
    }
    auto factory = plugins.find(name);
    if (!factory) {
      composition.findings.push_back(
          {Severity::error, component.place, factory.error().message});
      continue;
    }
    auto upkeep = component.upkeep;
    upkeep.deadline = call_deadline(upkeep, settings.sessions.request_timeout);
    *factory = hosted(std::move(*factory), upkeep, plugins.file_of(name));
    if (auto right = check_component(component.name, factory->description);
        !right)
      composition.findings.push_back(
          {Severity::error, component.place, right.error().message});
    check_options(component, factory->description, places, composition);
    check_scope(component, factory->description, composition);
    check_deadline(component, factory->description, settings.sessions,
                   composition);
    composition.components.push_back({component.name, std::move(*factory),
                                      component.options, component.place,
                                      upkeep});
  }
  return composition;
}

const ChosenComponent* first_of_role(const Composition& composition,
                                     std::string_view role) {
  for (const auto& component : composition.components) {
    if (component.upkeep.scope.instances == 0)
      continue; // not before it is loaded
    const auto& roles = component.factory.description.roles;
    if (std::find(roles.begin(), roles.end(), role) != roles.end())
      return &component;
  }
  return nullptr;
}

} // namespace parlour::tools
