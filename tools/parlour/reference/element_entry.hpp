// Entries of elements, from script/xml/elements.def.
#pragma once

#include <string>
#include <vector>

#include "script/xml/element_table.hpp"
#include "tools/parlour/reference/entry.hpp"

namespace parlour::tools {

// Of each element, in the table's order.
std::vector<Entry> element_entries();

// What may be repeated wherever "statements" are named.
Entry statements_entry();

// "<speak>"; "<NAME>" for whatever has no row of its own.
std::string tag_of(const std::string& element);

// "<speak>", or "<var> in <call>" where several elements have that name.
std::string title_of(const script::ElementRule& rule);

// "needed; a duration such as 200ms, 1.5s or 2m"
std::string kind_of(const script::AttributeRule& attribute);

} // namespace parlour::tools
