// Finds what the XML parser accepts although XML 1.0 forbids it: bad characters
// and references, comments, instructions, names, and the declaration. It looks
// at the text itself (language rule 1.3). Repeated attributes, tags that do not
// match and text outside of the root are found by the reader.
//
// Each mistake has its place and, if it is certain, the right spelling:
//
//   <speak param="Tea & cake"/>      '&' must be written &amp;
//   <!-- a -- b -->                  '--' may not stand in a comment
//   <a1:b/>, &eacute;, &#x0;         names and characters that XML forbids
#pragma once

#include <string_view>
#include <vector>

#include "script/xml/xml_mistakes.hpp"

namespace parlour::script {

// For a text that the parser accepted, without a byte order mark. The mistakes
// are in the order of the text, at most a thousand.
std::vector<XmlMistake> find_faults(std::string_view text);

} // namespace parlour::script
