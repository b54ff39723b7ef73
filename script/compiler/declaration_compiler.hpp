// DeclarationCompiler: from an application's documents to its program, in two
// passes: names, then bodies (language rules 1.3 and 1.7).
#pragma once

#include <vector>

#include "script/compiler/application_loader.hpp"
#include "script/program/program.hpp"
#include "script/source/findings.hpp"

namespace parlour::script {

// What the settings' tree says beyond Settings; null for a file by itself.
struct SettingsSource {
  const Element* root = nullptr;
};

// `program` holds the settings. Whatever is wrong is a finding.
void compile_declarations(const std::vector<Document>& documents,
                          SettingsSource settings,
                          const ApplicationLoader& loader, Program& program,
                          Findings& findings);

} // namespace parlour::script
