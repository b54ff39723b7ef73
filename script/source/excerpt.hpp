// Excerpt: the source line of a finding with its place underlined.
#pragma once

#include <string>

#include "script/source/findings.hpp"
#include "script/source/source_text.hpp"

namespace parlour::script {

// Two lines, each with a line end, such as
//
//      4 |   <speek param="Hello"/>
//        |   ^^^^^^
//
// Empty if the place is not in the text. A long line is cut to the part around
// the place.
std::string excerpt(const SourceText& source, const Finding& finding);

} // namespace parlour::script
