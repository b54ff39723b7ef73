// The edits that rename an element: in its start tag and, if it has one, in its
// end tag. Quick fixes use them.
#pragma once

#include <string>
#include <vector>

#include "script/source/findings.hpp"

namespace parlour::script {

// `begin` is the offset of the start tag's '<'. The result is empty if no tag
// begins there or its text is not well-formed.
std::vector<Edit> rename_tags(const std::string& text, std::size_t begin,
                              const std::string& name);

} // namespace parlour::script
