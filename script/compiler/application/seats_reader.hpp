// The <seat>s of settings.xml as data, and the components that they bind
// (engine rule 7.7).
#pragma once

#include <functional>
#include <string>

#include "runtime/base/settings.hpp"
#include "script/source/findings.hpp"
#include "script/source/source.hpp"

namespace parlour::script {

// Adds the seats to the settings, whose components and agents are known by
// then; one that a seat binds belongs to it from now on. `own_name` returns the
// plug-in's own name for one of its aliases.
void read_seats(const Element& root,
                const std::function<std::string(const std::string&)>& own_name,
                Settings& settings, Findings& findings);

} // namespace parlour::script
