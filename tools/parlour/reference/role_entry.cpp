// The commands of a role are listed as "understands", its events as "fires".
#include "tools/parlour/reference/role_entry.hpp"

#include <algorithm>

#include "runtime/message/roles.hpp"
#include "runtime/plugin/parameters.hpp"
#include "tools/parlour/reference/examples.hpp"

namespace parlour::tools {

namespace {

// What an event means to whoever waits with <request>.
const char* meaning(Reply reply) {
  switch (reply) {
  case Reply::answer:
    return "ends a request";
  case Reply::refusal:
    return "ends a request with an error";
  case Reply::none:
    break;
  }
  return "";
}

// "Audio(audio, utterance)"
template <class Named>
std::string signature(const Named& named) {
  return named.name + "(" + named.parameters + ")";
}

// Adds "name: kind" for each parameter in a list, each only once.
void add_parameters(std::vector<std::string>& all, const std::string& text) {
  for (const auto& parameter : read_parameters(text)) {
    auto words = parameter.name + ": ";
    words += sentence_of(parameter.kind);
    if (std::ranges::count(all, words) == 0)
      all.push_back(std::move(words));
  }
}

// The parameters of all commands and events of a role.
std::string parameters_of(const Role& role) {
  std::vector<std::string> all;
  for (const auto& command : role.commands)
    add_parameters(all, command.parameters);
  for (const auto& event : role.events)
    add_parameters(all, event.parameters);
  return listed(all, "; ");
}

void add_facts(Entry& entry, const Role& role) {
  if (role.reserved)
    entry.facts.push_back({"it is", "a source of the platform's own"});
  if (!role.aliases.empty())
    entry.facts.push_back({"also called", listed(role.aliases)});
  if (const auto all = parameters_of(role); !all.empty())
    entry.facts.push_back({"with", all});
  entry.facts.push_back(
      {"told in", role.reserved ? "docs/engine.md" : "12.11"});
}

} // namespace

// A role's details are its commands, then its events.
Entry role_entry(const Role& role) {
  Entry entry{role.name, role.name, role.sentence};
  add_facts(entry, role);
  for (const auto& command : role.commands)
    entry.details.push_back({"understands", signature(command),
                             command.answered ? "always answered" : ""});
  for (const auto& event : role.events)
    entry.details.push_back({"fires", signature(event), meaning(event.reply)});
  if (const auto* example = role_example(role.name))
    entry.example = example->xml;
  return entry;
}

std::vector<Entry> role_entries() {
  std::vector<Entry> entries;
  for (const auto& role : roles())
    entries.push_back(role_entry(role));
  return entries;
}

} // namespace parlour::tools
