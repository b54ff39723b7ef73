// Validator: a tree against the element table. Reports everything that the
// table knows to be wrong, and mends the tree so that later passes can go on
// without repeating it: what is unknown or misplaced is taken out, a missing
// expression becomes `unknown`, an element that is nothing without a missing
// attribute goes.
#pragma once

#include "script/source/findings.hpp"
#include "script/source/source.hpp"
#include "script/xml/element_table.hpp"

namespace parlour::script {

// False where the root itself is none of `roots` ("dialogue", "settings" …);
// the tree is then of no use.
bool validate(Element& root, const std::vector<std::string>& roots,
              Findings& findings);

} // namespace parlour::script
