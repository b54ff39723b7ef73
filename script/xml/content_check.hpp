// ContentCheck: how often and in which order children may stand in an element
// (ONCE, LAST and PARTS of elements.def). What is too much is taken out, so
// that nobody tells of it again.
#pragma once

#include "script/source/findings.hpp"
#include "script/source/source.hpp"
#include "script/xml/element_table.hpp"

namespace parlour::script {

// An empty part, such as the <else/> in front of its statements, becomes one
// around them, as all who come later know it.
void gather_parts(Element& element, const ElementRule& rule,
                  Findings& findings);

// One that is there once too often, or behind what ends the element.
void check_children(Element& element, const ElementRule& rule,
                    Findings& findings);

} // namespace parlour::script
