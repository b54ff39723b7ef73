// Checks how often and in which order children stand in an element (ONCE, LAST
// and PARTS of elements.def). Surplus children are removed after they were
// reported, so that later passes do not report them again.
//
// An example for each: a state's second <Entrance>; a statement behind a
// <try>'s <catch>; a statement behind an <else> that holds its own.
#pragma once

#include "script/source/findings.hpp"
#include "script/source/source.hpp"
#include "script/xml/element_table.hpp"

namespace parlour::script {

// Normalises the two ways of writing parts (language rule 6.1): an empty part
// such as <else/> in front of its statements becomes one that holds them, which
// is the only form that later passes know.
void gather_parts(Element& element, const ElementRule& rule,
                  Findings& findings);

// Reports and removes each child that occurs too often, or behind a child that
// must be the last.
void check_children(Element& element, const ElementRule& rule,
                    Findings& findings);

} // namespace parlour::script
