// What both schemas share: names of rows, spellings, patterns, sentences.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "script/xml/element_table.hpp"

namespace parlour::script {

// A row's own name in a schema; "e12.speak".
std::string schema_name(const ElementRule& rule);

// "speak" and "Speak": both are right (language rule 1.4).
std::vector<std::string> spellings(const std::string& name);

// The rows that may stand within these contents, in the table's order.
std::vector<const ElementRule*>
rows_within(const std::vector<std::string>& within);

bool is_free(const ElementRule& rule); // holds whatever one likes

// A regular expression of XML Schema for values of that kind; empty: any text.
std::string_view pattern_of(AttributeKind kind);

// The words of a choice, "true" and "false" of a boolean; else empty.
std::vector<std::string> words_of(const AttributeRule& rule);

// The row's sentence, with what it needs to be said besides.
std::string documentation(const ElementRule& rule);
std::string documentation(const AttributeRule& rule);

} // namespace parlour::script
