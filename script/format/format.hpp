// Format: the canonical layout of a script (language rule 14.4). The formatted
// text means the same, and formatting it again changes nothing.
#pragma once

#include <optional>
#include <string>

#include "script/source/findings.hpp"

namespace parlour::script {

// Nothing, and findings of the registered file `file`, where the text is not
// well-formed.
std::optional<std::string>
format_source(const std::string& text, std::uint16_t file, Findings& findings);

// Whether two trees are the same but for their places and for blanks between
// elements.
bool means_the_same(const Element& a, const Element& b);

} // namespace parlour::script
