// The XML declaration, <?xml version="1.0" encoding="UTF-8"?>: what stands in
// it and where (XML 1.0, 2.8 and 4.3.3).
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

#include "script/xml/xml_slips.hpp"

namespace parlour::script {

// Whether an XML declaration, or what was meant to be one, begins there.
bool is_xml_declaration(std::string_view text);

// What is wrong with the one that begins at `offset`; nothing where all is
// well.
std::optional<XmlSlip> declaration_fault(std::string_view text,
                                         std::size_t offset);

} // namespace parlour::script
