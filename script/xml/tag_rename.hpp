// The edits that give an element another name: in its start tag and, where it
// has one, in its end tag.
#pragma once

#include <string>
#include <vector>

#include "script/source/findings.hpp"

namespace parlour::script {

// `begin` is the offset of the start tag's '<'. Empty where no such tag stands
// there or the text is not well-formed.
std::vector<Edit> rename_tags(const std::string& text, std::size_t begin,
                              const std::string& name);

} // namespace parlour::script
