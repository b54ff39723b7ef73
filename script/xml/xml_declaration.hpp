// Checks the XML declaration, <?xml version="1.0" encoding="UTF-8"?> (XML 1.0,
// sections 2.8 and 4.3.3).
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

#include "script/xml/xml_mistakes.hpp"

namespace parlour::script {

// Whether an XML declaration, or something that was meant to be one, begins
// here.
bool is_xml_declaration(std::string_view text);

// What is wrong with the declaration at `offset`; nothing if it is correct.
std::optional<XmlMistake> declaration_fault(std::string_view text,
                                            std::size_t offset);

} // namespace parlour::script
