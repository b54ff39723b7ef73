// From the validated tree of settings.xml to Settings. Kinds and forms of
// values were checked by the element table; here are the checks that need
// several elements: names that are free, plug-ins that are listed, options that
// are given once.

#include "script/compiler/application/settings_reader.hpp"

#include <algorithm>
#include <chrono>
#include <optional>
#include <utility>

#include "runtime/message/roles.hpp"
#include "script/compiler/application/agents_reader.hpp"
#include "script/compiler/application/seats_reader.hpp"
#include "script/xml/attribute_check.hpp"

namespace parlour::script {

namespace {

// Durations that are missing or wrong leave the default.
void read_duration(const Element& element, const char* name,
                   Milliseconds& target) {
  if (const auto* attribute = element.attribute(name))
    target = parse_duration(attribute->value).value_or(target);
}

// A century: as long as the file system's clock can count back.
constexpr std::uint64_t most_days = 36'500;
constexpr Milliseconds longest_keep = std::chrono::hours(24) * most_days;

// "7d", which is no duration of scripts, or a duration; nothing for any other.
std::optional<Milliseconds> parse_keep(std::string_view text) {
  std::optional<Milliseconds> time;
  if (text.ends_with('d')) {
    const auto days = parse_count(text.substr(0, text.size() - 1));
    if (days && *days <= most_days)
      time = std::chrono::hours(24) * *days;
  } else if (const auto duration = parse_duration(text)) {
    time = *duration;
  }
  return time && *time <= longest_keep ? time : std::nullopt;
}

// Where and whether there is a journal, the command line says.
void read_journal(const Element& element, SessionSettings& sessions,
                  Findings& findings) {
  sessions.strict_journal = element.value("journal") == "strict";
  const auto* keep = element.attribute("keep");
  if (!keep)
    return;
  const auto time = parse_keep(keep->value);
  if (!time)
    findings.error(keep->value_position,
                   "keep=\"" + keep->value +
                       "\" of <sessions>: expected how long a finished "
                       "part of the journal is kept, such as 7d or 12h, and "
                       "36500d at most");
  sessions.keep_journal = time.value_or(sessions.keep_journal);
}

// <sessions>: attributes that are missing keep their defaults.
void read_sessions(const Element& element, SessionSettings& sessions,
                   Findings& findings) {
  read_duration(element, "resume-after", sessions.resume_after);
  read_duration(element, "no-input-after", sessions.no_input_after);
  read_duration(element, "context-for", sessions.context_for);
  read_duration(element, "request-timeout", sessions.request_timeout);
  read_duration(element, "rest-after", sessions.rest_after);
  read_duration(element, "closes-after", sessions.closes_after);
  read_journal(element, sessions, findings);
}

// Wrong values were reported by the validator; they leave the default.
template <class T>
void read_number(const Element& element, const char* name, T& target) {
  if (const auto* attribute = element.attribute(name))
    target = static_cast<T>(parse_size(attribute->value).value_or(target));
}

// <limits>; sizes may have a unit, plain numbers are read the same way.
void read_limits(const Element& element, Limits& limits) {
  read_number(element, "instructions", limits.instructions);
  read_number(element, "depth", limits.depth);
  read_number(element, "bytes", limits.bytes);
  read_number(element, "result", limits.result);
}

// Reads <Plugins> first, because a <component> may configure one of them.
class SettingsReader {
public:
  SettingsReader(const Aliases& aliases, Environment environment,
                 Findings& findings)
      : aliases_(aliases), environment_(environment), findings_(findings) {}

  Settings read(const Element& root);

private:
  void read_plugins(const Element& element);
  void read_component(const Element& element);
  void read_policy(const Element& element, ComponentPolicy& policy);
  void read_scripts(const Element& element);
  void check_agents(const Element& root);
  std::string own_name(const std::string& name) const;
  ComponentSettings* find(const std::string& name);
  SourceLocation place(const Element& element) const {
    return findings_.place(element.position);
  }

  const Aliases& aliases_;
  Environment environment_;
  Findings& findings_;
  Settings settings_;
  std::map<std::string, std::uint32_t> described_; // components: their lines
};

// The plug-in's own name for one of its aliases.
std::string SettingsReader::own_name(const std::string& name) const {
  const auto found = aliases_.find(name);
  return found == aliases_.end() ? name : found->second;
}

// A component by its name; null if there is none yet.
ComponentSettings* SettingsReader::find(const std::string& name) {
  for (auto& component : settings_.components)
    if (component.name == name)
      return &component;
  return nullptr;
}

// Each <Plugin> is a component of the plug-in's name. Their order is the order
// of preference within a role.
void SettingsReader::read_plugins(const Element& element) {
  for (const auto& plugin : element.children) {
    const auto name = own_name(collapsed(plugin.text));
    const auto fault = wrong_source_name(name);
    if (name.empty())
      findings_.error(plugin.position, "<Plugin> is empty; expected the name "
                                       "of a plug-in");
    else if (!fault.empty())
      findings_.error(plugin.position, fault);
    else if (find(name))
      findings_.error(plugin.position,
                      "the plug-in '" + name + "' is listed twice");
    else
      settings_.components.push_back({name, name, {}, place(plugin)});
  }
}

// A <component> either configures a listed plug-in or, with `plugin`, adds a
// further instance of one under its own name.
void SettingsReader::read_component(const Element& element) {
  const auto* plugin = element.attribute("plugin");
  const auto name =
      plugin ? element.value("name") : own_name(element.value("name"));
  if (const auto fault = wrong_source_name(name); plugin && !fault.empty())
    return findings_.error(element.attribute("name")->value_position, fault);
  auto* component = find(name);
  if (component && plugin)
    return findings_.error(element.position,
                           "there is a component '" + name + "' already");
  if (!component) {
    if (!plugin) {
      std::vector<std::string> known;
      for (const auto& one : settings_.components)
        known.push_back(one.name);
      return findings_.error(element.position,
                             "'" + name + "' is not in <Plugins>" +
                                 did_you_mean(name, known) +
                                 (did_you_mean(name, known).empty()
                                      ? "; list it there, or, for a further "
                                        "instance, say plugin=\"…\""
                                      : ""));
    }
    settings_.components.push_back(
        {name, own_name(plugin->value), {}, place(element)});
    component = &settings_.components.back();
  }
  const auto [first, is_first] =
      described_.emplace(name, element.position.line);
  if (!is_first)
    findings_.error(element.position, "a second <component name=\"" + name +
                                          "\">, after the one in line " +
                                          std::to_string(first->second) +
                                          "; put both into one");
  read_policy(element, component->policy);
  read_options(element, name, environment_, findings_, component->options);
}

// How the component is operated: deadline, host process and scope.
void SettingsReader::read_policy(const Element& element,
                                 ComponentPolicy& policy) {
  if (const auto* deadline = element.attribute("deadline"))
    if (const auto time = parse_duration(deadline->value))
      policy.deadline = *time;
  if (policy.deadline && *policy.deadline <= Milliseconds::zero())
    findings_.error(element.attribute("deadline")->value_position,
                    "deadline=\"" + element.value("deadline") +
                        "\": no call can be that short");
  policy.host = element.value("host");
  const auto* scope = element.attribute("scope");
  if (!scope)
    return;
  if (auto parsed = parse_scope(scope->value))
    policy.scope = *parsed;
  else
    findings_.error(scope->value_position, "scope=\"" + scope->value +
                                               "\": " + parsed.error().message);
}

// Only the names; the loader reads the files.
void SettingsReader::read_scripts(const Element& element) {
  for (const auto& script : element.children)
    settings_.scripts.push_back(collapsed(script.text));
}

// A message for a name must have one receiver.
void SettingsReader::check_agents(const Element& root) {
  const auto* agents = root.child("agents");
  if (!agents)
    return;
  for (const auto& agent : agents->children)
    if (find(agent.value("name")))
      findings_.error(agent.attribute("name")->value_position,
                      "there is a component '" + agent.value("name") +
                          "' already");
}

// Two rounds, as a <component> may stand before the <Plugins> that it refers
// to.
Settings SettingsReader::read(const Element& root) {
  settings_.name = root.value("name");
  settings_.start = root.value("start");
  settings_.unsafe_sql = root.value("unsafe-sql") == "true";
  for (const auto& child : root.children)
    if (child.is("Plugins"))
      read_plugins(child);
  for (const auto& child : root.children) {
    if (child.is("component"))
      read_component(child);
    else if (child.is("Scripts"))
      read_scripts(child);
    else if (child.is("agents"))
      settings_.agents = read_agents(child, environment_, findings_);
    else if (child.is("sessions"))
      read_sessions(child, settings_.sessions, findings_);
    else if (child.is("limits"))
      read_limits(child, settings_.limits);
  }
  check_agents(root);
  read_seats(
      root, [this](const std::string& name) { return own_name(name); },
      settings_, findings_);
  return std::move(settings_);
}

} // namespace

// The first of two equal aliases counts.
Aliases read_aliases(const Element& root) {
  Aliases aliases;
  for (const auto& alias : root.children)
    aliases.emplace(alias.value("name"), alias.value("plugin"));
  return aliases;
}

Settings read_settings(const Element& root, const Aliases& aliases,
                       std::string (*environment)(const std::string&),
                       Findings& findings) {
  return SettingsReader(aliases, environment, findings).read(root);
}

} // namespace parlour::script
