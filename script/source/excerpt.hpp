// What a reader sees of a finding: its line in the file and a mark under the
// place.
#pragma once

#include <string>

#include "script/source/findings.hpp"
#include "script/source/source_text.hpp"

namespace parlour::script {

//    4 |   <speek param="Hello"/>
//      |   ^^^^^^
// Two lines, each with its end; empty where the place is not in the text. Of
// long lines, what stands around the place.
std::string excerpt(const SourceText& source, const Finding& finding);

} // namespace parlour::script
