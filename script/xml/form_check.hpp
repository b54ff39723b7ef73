// Checks which attributes of an element go together (FORM), and that nothing is
// said by both an attribute and a child (EITHER of elements.def).
//
// For example <for> either counts (name, from, to) or walks over a collection
// (each, in); attributes of both are a contradiction.
#pragma once

#include <vector>

#include "script/source/findings.hpp"
#include "script/source/source.hpp"
#include "script/xml/element_table.hpp"

namespace parlour::script {

// Reports and removes attributes that contradict earlier ones or repeat what a
// child says. Returns false if an attribute contradicted another: it is then
// unknown which form was meant.
bool check_forms(Element& element, const ElementRule& rule, Findings& findings);

// The attributes of which one is needed to complete a form; empty if some form
// is complete.
std::vector<const AttributeRule*> missing_of_form(const Element& element,
                                                  const ElementRule& rule);

} // namespace parlour::script
