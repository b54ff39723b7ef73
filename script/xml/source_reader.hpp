// Reads XML text into a tree of Elements with positions (language rules 1.3 and
// 1.4). The work is done by pugixml and by checks of our own for what it lets
// pass (well_formed.hpp) or cannot explain (xml_mistakes.hpp). Everything that
// is not well-formed becomes a finding; nothing throws, and the depth of
// nesting is limited, so no text can exhaust the stack.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

#include "script/source/findings.hpp"
#include "script/source/source.hpp"

namespace parlour::script {

inline constexpr std::size_t largest_source = 16 << 20; // bytes
inline constexpr std::size_t deepest_elements = 200;

// The root element of `text`, which is registered as `file` in the findings;
// nothing if there were errors. A document with errors is not returned in part,
// because its tree could be far from what was meant.
std::optional<Element> read_source(std::string text, std::uint16_t file,
                                   Findings& findings);

// Reads a file of at most `largest_source` bytes.
Expected<std::string> read_bytes(const std::filesystem::path& path);

} // namespace parlour::script
