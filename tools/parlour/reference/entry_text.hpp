// An entry as text for a terminal of 80 columns.
#pragma once

#include <string>
#include <string_view>

#include "tools/parlour/reference/entry.hpp"

namespace parlour::tools {

inline constexpr std::size_t text_width = 80;

// Several lines, each ended.
std::string entry_text(const Entry& entry);

// The words behind `label`, from `column` on where that is shorter; further
// lines begin there. Ended.
std::string paragraph(const std::string& label, std::string_view words,
                      std::size_t column);

// "language rule 5.1 (script/LANGUAGE.md)", "docs/repair.md"
std::string place_text(const std::string& told);

} // namespace parlour::tools
