// Ways: how an element may be written, from FORM and EITHER of the element
// table: which attributes together, and without which children.
#pragma once

#include <string>
#include <vector>

#include "script/xml/element_table.hpp"

namespace parlour::script {

// One attribute of a way; of a choice perhaps some of its words only.
struct WayAttribute {
  AttributeRule rule;
  bool required = false;
};

struct Way {
  std::vector<WayAttribute> attributes;
  // Children that one of the attributes stands for; "text": character data.
  std::vector<std::string> without;

  bool leaves_out(const std::string& child) const;
};

// At least one.
std::vector<Way> ways_of(const ElementRule& rule);

} // namespace parlour::script
