// DeclarationCompiler: turns an application's documents into its program in two
// passes (language rules 1.3 and 1.7). The first collects all names, the second
// compiles bodies. Two passes are needed because a body may mention what is
// declared later or in another file, and a wrong name should be answered with
// the nearest right one.
#pragma once

#include <vector>

#include "script/compiler/application/application_loader.hpp"
#include "script/program/program.hpp"
#include "script/source/findings.hpp"

namespace parlour::script {

// What only the tree of the settings has, such as the ladder; null for a single
// file.
struct SettingsSource {
  const Element* root = nullptr;
};

// `program` must have the settings already. Mistakes become findings.
void compile_declarations(const std::vector<Document>& documents,
                          SettingsSource settings,
                          const ApplicationLoader& loader, Program& program,
                          Findings& findings);

} // namespace parlour::script
