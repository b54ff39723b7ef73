// Entries of the reference for XML elements, made from script/xml/elements.def.
#pragma once

#include <string>
#include <vector>

#include "script/xml/element_table.hpp"
#include "tools/parlour/reference/entry.hpp"

namespace parlour::tools {

// An entry for each row of the table, in its order. Elements of the same name
// in different places have several rows.
std::vector<Entry> element_entries();

// The entry for "statements", the content that most actions hold.
Entry statements_entry();

// "<speak>". A row named "*" stands for elements that an application names
// itself; its tag is "<NAME>".
std::string tag_of(const std::string& element);

// An entry's title: the tag, with its place if several elements have the name:
// "<var> in <call>".
std::string title_of(const script::ElementRule& rule);

// What an attribute takes: "needed; a duration such as 200ms, 1.5s or 2m".
std::string kind_of(const script::AttributeRule& attribute);

} // namespace parlour::tools
