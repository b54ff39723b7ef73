// What the XML parser lets pass although XML 1.0 does not, looked at in the
// text itself (language rule 1): characters and references, comments,
// instructions, names, the declaration. What stands twice in a tag, tags that
// do not match and text outside of the root element are the reader's.
#pragma once

#include <string_view>
#include <vector>

#include "script/xml/xml_slips.hpp"

namespace parlour::script {

// Of a text that the parser took, without a byte order mark; in its order.
std::vector<XmlSlip> find_faults(std::string_view text);

} // namespace parlour::script
