// Whether an attribute's value is of the kind that the element table wants.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "script/xml/element_table.hpp"

namespace parlour::script {

// What is wrong with the value, as a sentence; empty where nothing is. Kinds
// that only a compiler can judge (expressions, references) are right here.
std::string wrong_value(const ElementRule& element, const AttributeRule& rule,
                        const std::string& value);

// A letter or _, then letters, digits or _; letters beyond ASCII included.
bool is_identifier(std::string_view text);

// Why a variable or parameter cannot be called so; empty where it can.
std::string variable_fault(std::string_view name);

// "500", "64KB", "16MB", "1GB"; nothing where it is none of these.
std::optional<std::size_t> parse_size(std::string_view text);

// A whole number, 0 or more.
std::optional<std::uint64_t> parse_count(std::string_view text);

} // namespace parlour::script
