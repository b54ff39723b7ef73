// Which characters XML 1.0 allows, and which of them make up names (XML 1.0,
// sections 2.2 and 2.3).
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace parlour::script {

// Whether the character with this code point may occur in XML at all.
bool is_xml_character(std::uint32_t code);

// The length in bytes of the name at the start of `text`, which must be UTF-8;
// 0 if there is no name.
std::size_t xml_name_length(std::string_view text);

} // namespace parlour::script
