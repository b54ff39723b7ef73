// Ways: the ways to write an element, from FORM and EITHER of the element
// table: which attributes together, and without which children. Schemas need
// them spelled out.
//
// An example: <post> has an optional `param` and EITHER("param", "param"), so
// it has two ways: with the attribute and without <param> children, and without
// the attribute.
#pragma once

#include <string>
#include <vector>

#include "script/xml/element_table.hpp"

namespace parlour::script {

// An attribute of a way. Its words may be limited to some of a choice.
struct WayAttribute {
  AttributeRule rule;
  bool required = false;
};

// One way of writing an element.
struct Way {
  std::vector<WayAttribute> attributes;
  // Children that an attribute of this way replaces; "text" is character data.
  std::vector<std::string> without;

  bool leaves_out(const std::string& child) const;
};

// All ways to write the element; at least one.
std::vector<Way> ways_of(const ElementRule& rule);

} // namespace parlour::script
