// Prints an entry as text for a terminal of 80 columns.
#pragma once

#include <string>
#include <string_view>

#include "tools/parlour/reference/entry.hpp"

namespace parlour::tools {

inline constexpr std::size_t text_width = 80;

// Several lines, each with its line end.
std::string entry_text(const Entry& entry);

// The words, wrapped to text_width behind `label`. They start in `column`, or
// behind the label if that is longer; further lines are indented to `column`.
// Ends with a line end.
std::string paragraph(const std::string& label, std::string_view words,
                      std::size_t column);

// The place that `told` means, in full: the text for 5.1 is "language rule 5.1
// (script/LANGUAGE.md)"; a name that begins with "engine" is a rule of the
// engine; anything else is a page and stays.
std::string place_text(const std::string& told);

} // namespace parlour::tools
