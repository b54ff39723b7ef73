// What both schemas share: names of rows, spellings, patterns, sentences.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "script/xml/element_table.hpp"

namespace parlour::script {

// A unique name for a row, such as "e12.speak": several rows may have the same
// element name.
std::string schema_name(const ElementRule& rule);

// Both spellings of a name, "speak" and "Speak" (language rule 1.4).
std::vector<std::string> spellings(const std::string& name);

// The rows that may stand within these contents, in the order of the table.
std::vector<const ElementRule*>
rows_within(const std::vector<std::string>& within);

bool is_free(const ElementRule& rule); // holds anything

// A regular expression of XML Schema for values of this kind; empty: any text.
std::string_view pattern_of(AttributeKind kind);

// The words of a choice; "true" and "false" for a boolean; empty for others.
std::vector<std::string> words_of(const AttributeRule& rule);

// The row's sentence, with a note if the element is not available yet.
std::string documentation(const ElementRule& rule);
std::string documentation(const AttributeRule& rule);

} // namespace parlour::script
