// Reads <agents> of settings.xml (docs/agents.md): where remote agents connect,
// and who may.
#pragma once

#include "runtime/base/settings.hpp"
#include "script/compiler/application/environment_text.hpp"

namespace parlour::script {

// The element must have been validated. Mistakes become findings.
AgentsSettings read_agents(const Element& element, Environment environment,
                           Findings& findings);

} // namespace parlour::script
