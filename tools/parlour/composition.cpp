#include "tools/parlour/composition.hpp"

#include <algorithm>
#include <map>

#include "adapters/database/mariadb_database.hpp"
#include "adapters/database/sqlite_database.hpp"
#include "adapters/nlg/phrase_nlg.hpp"
#include "adapters/nlu/grammar_nlu.hpp"
#include "adapters/standins/log_devices.hpp"
#include "adapters/standins/log_reports.hpp"
#include "adapters/standins/log_robot.hpp"
#include "adapters/standins/log_sms.hpp"
#include "adapters/standins/log_taxi.hpp"
#include "adapters/standins/log_telephone.hpp"

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

std::vector<std::string> names_of(const std::vector<PluginFactory>& plugins) {
  std::vector<std::string> names;
  for (const auto& plugin : plugins)
    names.push_back(plugin.description.name);
  for (const auto& [name, instead] : voice_plugins())
    names.push_back(name);
  return names;
}

const PluginFactory* find_in(const std::vector<PluginFactory>& plugins,
                             std::string_view name) {
  const auto found = std::find_if(plugins.begin(), plugins.end(),
                                  [&](const PluginFactory& plugin) {
                                    return plugin.description.name == name;
                                  });
  return found == plugins.end() ? nullptr : &*found;
}

// Whom a finding is about: the plug-in, where need be of which component.
std::string whose(const ComponentSettings& component) {
  return component.name == component.plugin
             ? component.plugin
             : component.name + ": " + component.plugin;
}

void check_options(const ComponentSettings& component,
                   const PluginDescription& plugin, Composition& composition) {
  std::vector<std::string> known;
  for (const auto& option : plugin.options) {
    known.push_back(option.name);
    if (option.required && component.options.count(option.name) == 0)
      composition.findings.push_back({Severity::error, component.place,
                                      component.name + ": the option '" +
                                          option.name +
                                          "' is missing: " + option.sentence});
  }
  for (const auto& [name, value] : component.options)
    if (std::find(known.begin(), known.end(), name) == known.end())
      composition.findings.push_back({Severity::error, component.place,
                                      whose(component) + " has no option '" +
                                          name + "'" +
                                          script::did_you_mean(name, known)});
}

void report_missing(const ComponentSettings& component,
                    const std::vector<PluginFactory>& plugins,
                    Composition& composition) {
  const auto voice = voice_plugins().find(component.plugin);
  if (voice != voice_plugins().end())
    composition.notices.push_back(
        component.plugin + " is not available in this build: " + voice->second);
  else
    composition.findings.push_back(
        {Severity::error, component.place,
         "there is no plug-in '" + component.plugin + "'" +
             script::did_you_mean(component.plugin, names_of(plugins))});
}

} // namespace

const std::vector<PluginFactory>& built_in_plugins() {
  static const std::vector<PluginFactory> plugins = {
      adapters::grammar_nlu_factory(),     adapters::phrase_nlg_factory(),
      adapters::sqlite_database_factory(), adapters::mysql_database_factory(),
      adapters::log_telephone_factory(),   adapters::log_taxi_factory(),
      adapters::log_sms_factory(),         adapters::log_weather_factory(),
      adapters::log_traffic_factory(),     adapters::log_robot_factory(),
      adapters::log_devices_factory(),
  };
  return plugins;
}

const PluginFactory* find_plugin(std::string_view name) {
  return find_in(built_in_plugins(), name);
}

Composition compose(const Settings& settings) {
  return compose(settings, built_in_plugins());
}

Composition compose(const Settings& settings,
                    const std::vector<PluginFactory>& plugins) {
  Composition composition;
  for (const auto& component : settings.components) {
    const auto* factory = find_in(plugins, component.plugin);
    if (!factory) {
      report_missing(component, plugins, composition);
      continue;
    }
    check_options(component, factory->description, composition);
    composition.components.push_back(
        {component.name, *factory, component.options, component.place});
  }
  return composition;
}

const ChosenComponent* first_of_role(const Composition& composition,
                                     std::string_view role) {
  for (const auto& component : composition.components) {
    const auto& roles = component.factory.description.roles;
    if (std::find(roles.begin(), roles.end(), role) != roles.end())
      return &component;
  }
  return nullptr;
}

} // namespace parlour::tools
