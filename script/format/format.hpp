// Format: the canonical layout of a script (language rule 14.4). The result
// means the same as the original, and formatting it again changes nothing.
//
//   <if   cond = "a" ><print param="x"/></if>      as it is written
//
//   <if cond="a"><print param="x"/></if>           formatted
#pragma once

#include <optional>
#include <string>

#include "script/source/findings.hpp"

namespace parlour::script {

// The formatted text. Returns nothing if the text is not well-formed; findings
// of the registered file `file` say why.
std::optional<std::string>
format_source(const std::string& text, std::uint16_t file, Findings& findings);

// Whether two trees are equal except for positions and blanks between elements.
bool means_the_same(const Element& a, const Element& b);

} // namespace parlour::script
