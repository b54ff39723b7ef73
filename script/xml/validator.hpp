// Validator: checks a tree against the element table. It reports everything
// that the table knows to be wrong and repairs the tree, so that later passes
// neither stumble nor report the same again:
//
//   unknown or misplaced element   removed, or renamed if it is known what was
//                                  meant
//   wrong or unknown attribute     removed, or renamed likewise
//   missing expression             `unknown` is put in its place
//   other missing attribute        the element is removed
//
// Messages are as specific as the tables allow: a known element at a wrong
// place is told where it belongs, an unknown one what it is called here or
// which name is similar, text where it could stand. The tree is walked once,
// from the outside in.
#pragma once

#include "script/source/findings.hpp"
#include "script/source/source.hpp"
#include "script/xml/element_table.hpp"

namespace parlour::script {

// Checks and repairs the tree. Returns false if the root is not one of `roots`
// ("dialogue", "settings" …); the tree is then useless.
bool validate(Element& root, const std::vector<std::string>& roots,
              Findings& findings);

} // namespace parlour::script
