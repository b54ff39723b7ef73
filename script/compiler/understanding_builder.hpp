// From an application's documents to what language understanding needs to
// know of it (runtime/base/understanding.hpp).
#pragma once

#include <memory>
#include <vector>

#include "script/compiler/application_loader.hpp"
#include "script/program/program.hpp"

namespace parlour::script {

// The program's topics are compiled before. Grammars that stand in files are
// read; one that cannot be is a finding.
std::shared_ptr<const UnderstandingModel>
build_understanding(const std::vector<Document>& documents,
                    const Program& program, const ApplicationLoader& loader,
                    Findings& findings);

// The names of the grammars of a script.
void collect_grammars(const Element& root, std::vector<std::string>& names,
                      Findings& findings);

} // namespace parlour::script
