// SourceReader: XML text to a tree of Elements with positions (language rules
// 1.3 and 1.4). Whatever is not well-formed is a finding with its place;
// nothing throws, and no depth of nesting harms the stack.
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

// The root element of `text`, which is the registered file `file`; nothing
// where there were errors.
std::optional<Element> read_source(std::string text, std::uint16_t file,
                                   Findings& findings);

// The bytes of a file that is no larger than `largest_source`.
Expected<std::string> read_bytes(const std::filesystem::path& path);

} // namespace parlour::script
