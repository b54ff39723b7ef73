// Composition: which plug-ins the settings have chosen, under which component
// names and with which options (architecture rule 7). It is data: nothing is
// started here. node_options.hpp turns it into a node's components.
#pragma once

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "adapters/agents/component/remote_agent.hpp"
#include "runtime/base/settings.hpp"
#include "runtime/plugin/plugin.hpp"
#include "script/source/findings.hpp"
#include "tools/parlour/application/plugins/catalogue.hpp"

namespace parlour::tools {

// A component that the settings ask for.
struct ChosenComponent {
  std::string name; // as scripts address it
  // Makes its instances, perhaps in a process of their own
  // (process_isolation.hpp).
  PluginFactory factory;
  Options options;
  SourceLocation place; // of <component> or <Plugin>
  // Its scope, deadline and host.
  ComponentPolicy policy = {};
  // If it is a remote agent: what it is where agents can connect
  // (agent_listener.hpp). `factory` and `options` are those of its stand-in,
  // which takes its place elsewhere.
  std::optional<adapters::agents::RemoteAgentOrder> agent = {};
};

struct Composition {
  std::vector<ChosenComponent> components; // by priority for a role
  std::vector<script::Finding> findings;   // about names and options
  // One sentence for each plug-in of a voice seat that this build lacks. The
  // application is correct and works without it.
  std::vector<std::string> notices;
  // Nothing outside is reached and nothing is kept (rehearsed).
  bool is_rehearsed = false;
};

// Finds the place of a component's option in the settings, if it is there.
// compose() calls it for mistakes only, because finding the place reads the
// file again. Without a place, a finding is reported at the component.
using OptionPlaces = std::function<std::optional<SourceLocation>(
    const std::string& component, const std::string& option)>;

// Finds and checks the plug-in of each component of the settings, and the
// stand-in of each remote agent. A component whose plug-in cannot be found is
// left out and reported in `findings`. Agents come first: they are preferred.
Composition compose(const Settings& settings, Catalogue& plugins,
                    const OptionPlaces& places = {});

// Whether it has that role.
bool fills(const ChosenComponent& component, std::string_view role);

// The first component with that role that the settings start; null if there is
// none. A component with 0 instances waits for <load> and does not count.
const ChosenComponent* first_of_role(const Composition& composition,
                                     std::string_view role);

// The roles of each component, by its name.
std::map<std::string, std::vector<std::string>>
roles_by_component(const Composition& composition);

// The names of all components with that role.
std::set<std::string, std::less<>> names_of_role(const Composition& composition,
                                                 std::string_view role);

} // namespace parlour::tools
