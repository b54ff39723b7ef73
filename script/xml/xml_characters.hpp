// Which characters XML 1.0 knows, and what names are made of (XML 1.0, 2.2 and
// 2.3).
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace parlour::script {

// Whether a character of that number may stand in XML at all.
bool is_xml_character(std::uint32_t code);

// The bytes of the name that `text`, which is UTF-8, begins with; 0: none.
std::size_t xml_name_length(std::string_view text);

} // namespace parlour::script
