// What the XML parser lets pass or cannot explain, looked at in the text
// itself.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

namespace parlour::script {

// An element that is still open somewhere in a text.
struct OpenElement {
  std::string name;
  std::size_t offset = 0; // of its start tag
};

// Why the tags of a text do not match, where they do not.
struct TagProblem {
  std::size_t offset = 0;
  std::string found; // the end tag that fits nothing, or empty
  OpenElement open;  // what was open there; name may be empty
};

// The first end tag that closes what is not open, or the innermost element
// that is never closed; nothing (offset npos) where all tags match.
TagProblem find_tag_problem(std::string_view text);

// Calls `report(offset, sentence)` for every `&` that begins no entity, and,
// in an attribute's value, every `<`.
void check_characters(
    std::string_view text, std::size_t offset, bool in_attribute,
    const std::function<void(std::size_t, std::string)>& report);

} // namespace parlour::script
