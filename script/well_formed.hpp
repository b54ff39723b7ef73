// What the XML parser lets pass or cannot explain, looked at in the text
// itself.
#pragma once

#include <cstddef>
#include <functional>
#include <string_view>

#include "script/xml_slips.hpp"

namespace parlour::script {

// Reports every `&` that begins no entity, and, in an attribute's value, every
// `<`.
void check_characters(std::string_view text, std::size_t offset,
                      bool in_attribute,
                      const std::function<void(const XmlSlip&)>& report);

} // namespace parlour::script
