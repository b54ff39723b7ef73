// SettingsReader: settings.xml as data (docs/writing.md). The tree is validated
// before.
#pragma once

#include <map>
#include <string>

#include "runtime/base/settings.hpp"
#include "script/source/findings.hpp"
#include "script/source/source.hpp"

namespace parlour::script {

// Other names of plug-ins, from the platform's aliases.xml.
using Aliases = std::map<std::string, std::string, std::less<>>;

Aliases read_aliases(const Element& root);

// `environment` answers ${NAME}; null: nothing is set. Values of the
// environment are in no finding.
Settings read_settings(const Element& root, const Aliases& aliases,
                       std::string (*environment)(const std::string&),
                       Findings& findings);

} // namespace parlour::script
