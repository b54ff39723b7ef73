// FormCheck: which attributes of an element go together, and which of them say
// what a child says (FORM and EITHER of elements.def).
#pragma once

#include <vector>

#include "script/source/findings.hpp"
#include "script/source/source.hpp"
#include "script/xml/element_table.hpp"

namespace parlour::script {

// What excludes another one, or says the same as a child, is told and taken
// out; false: who knows in which form it was meant to be.
bool check_forms(Element& element, const ElementRule& rule, Findings& findings);

// What the element still needs to have one of its forms: one of these. Empty:
// nothing.
std::vector<const AttributeRule*> missing_of_form(const Element& element,
                                                  const ElementRule& rule);

} // namespace parlour::script
