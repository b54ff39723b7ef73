// Checks an attribute's value against the kind that the element table wants.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "script/xml/element_table.hpp"

namespace parlour::script {

// What is wrong with the value, as a sentence; empty if nothing is. Kinds that
// need knowledge of the application (expressions, references to states and so
// on) pass here; the compiler judges them.
std::string wrong_value(const ElementRule& element, const AttributeRule& rule,
                        const std::string& value);

// Whether the text is a letter or _, followed by letters, digits or _.
// Characters beyond ASCII count as letters.
bool is_identifier(std::string_view text);

// Why this cannot be the name of a variable or parameter; empty if it can.
std::string variable_fault(std::string_view name);

// Reads "500", "64KB", "16MB" or "1GB" as a number of bytes; nothing if the
// text has another form.
std::optional<std::size_t> parse_size(std::string_view text);

// Reads a whole number, 0 or more.
std::optional<std::uint64_t> parse_count(std::string_view text);

} // namespace parlour::script
