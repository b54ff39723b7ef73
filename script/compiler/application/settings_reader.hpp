// SettingsReader: settings.xml as data (docs/writing.md). The tree must have
// been validated.
//
// Defaults are those of runtime/base/defaults.hpp. Mistakes become findings;
// the settings are then as complete as possible, so that compiling goes on.
#pragma once

#include <map>
#include <string>

#include "runtime/base/settings.hpp"
#include "script/compiler/application/environment_text.hpp"
#include "script/source/findings.hpp"
#include "script/source/source.hpp"

namespace parlour::script {

// Alternative names of plug-ins, from the platform's aliases.xml.
using Aliases = std::map<std::string, std::string, std::less<>>;

Aliases read_aliases(const Element& root);

// `environment` returns the value for ${NAME} (environment_text.hpp).
Settings read_settings(const Element& root, const Aliases& aliases,
                       Environment environment, Findings& findings);

} // namespace parlour::script
