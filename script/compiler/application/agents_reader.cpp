#include "script/compiler/application/agents_reader.hpp"

#include <algorithm>
#include <utility>

#include "runtime/message/roles.hpp"
#include "runtime/text/words.hpp"

namespace parlour::script {

namespace {

class AgentsReader {
public:
  AgentsReader(Environment environment, Findings& findings)
      : environment_(environment), findings_(findings) {}

  AgentsSettings read(const Element& element) {
    AgentsSettings settings;
    settings.place = findings_.place(element.position);
    read_address(element, "lines", settings.lines);
    read_address(element, "zeromq", settings.zeromq);
    read_address(element, "taps", settings.taps);
    settings.certificate = text(element, "certificate");
    settings.private_key = text(element, "private-key");
    settings.secret_key = text(element, "secret-key");
    check_certificate(element, settings);
    for (const auto& child : element.children)
      add(read_agent(child), child, settings.agents);
    return settings;
  }

private:
  std::string text(const Element& element, const char* name) {
    const auto* attribute = element.attribute(name);
    return attribute ? with_environment(*attribute, environment_, findings_)
                     : std::string();
  }

  void read_address(const Element& element, const char* name,
                    std::string& address) {
    if (element.attribute(name))
      address = text(element, name);
    if (address == "off")
      address.clear();
  }

  // Each is of no use without the other.
  void check_certificate(const Element& element,
                         const AgentsSettings& settings) {
    if (settings.certificate.empty() != settings.private_key.empty())
      findings_.error(element.position, "<agents> needs both 'certificate' "
                                        "and 'private-key', or neither");
  }

  AgentSettings read_agent(const Element& element) {
    AgentSettings agent;
    agent.name = element.value("name");
    agent.roles = read_roles(element);
    agent.token = text(element, "token");
    agent.key = text(element, "key");
    agent.stand_in = element.value("stand-in");
    agent.place = findings_.place(element.position);
    read_options(element, agent.name, environment_, findings_, agent.options);
    if (agent.roles.empty() && agent.stand_in.empty())
      findings_.error(element.position,
                      "the agent '" + agent.name +
                          "' needs 'roles', or a 'stand-in' that has some");
    return agent;
  }

  std::vector<std::string> read_roles(const Element& element) {
    const auto* attribute = element.attribute("roles");
    std::vector<std::string> roles;
    if (!attribute)
      return roles;
    for (const auto& word : split_words(attribute->value)) {
      const auto* role = find_role(word);
      if (!role || role->reserved)
        findings_.error(attribute->value_position,
                        "'" + word +
                            "' is no role that an agent can fill; "
                            "see `parlour plugin roles`");
      else
        roles.push_back(role->name);
    }
    return roles;
  }

  // Agents speak under their own names, so these must be free.
  void add(AgentSettings agent, const Element& element,
           std::vector<AgentSettings>& agents) {
    const auto position = element.attribute("name")->value_position;
    const auto same = [&](const AgentSettings& other) {
      return other.name == agent.name;
    };
    if (const auto fault = wrong_source_name(agent.name); !fault.empty())
      findings_.error(position, fault);
    else if (std::ranges::any_of(agents, same))
      findings_.error(position,
                      "there is an agent '" + agent.name + "' already");
    else
      agents.push_back(std::move(agent));
  }

  Environment environment_;
  Findings& findings_;
};

} // namespace

AgentsSettings read_agents(const Element& element, Environment environment,
                           Findings& findings) {
  return AgentsReader(environment, findings).read(element);
}

} // namespace parlour::script
