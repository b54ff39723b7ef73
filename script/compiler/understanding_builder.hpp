// Builds what language understanding needs to know of an application from its
// documents (runtime/message/understanding.hpp).
//
// The model is plain data without pointers into the program, so a component in
// another process can have it, too.
#pragma once

#include <memory>
#include <vector>

#include "script/compiler/application/application_loader.hpp"
#include "script/program/program.hpp"

namespace parlour::script {

// The program's topics must have been compiled. Grammars in files are read; a
// file that cannot be read is a finding.
std::shared_ptr<const UnderstandingModel>
build_understanding(const std::vector<Document>& documents,
                    const Program& program, const ApplicationLoader& loader,
                    Findings& findings);

// The names of the grammars in a script; reports duplicates.
void collect_grammars(const Element& root, std::vector<std::string>& names,
                      Findings& findings);

} // namespace parlour::script
