// Reads one tag of a text that may be anything but well-formed, tells its
// slips, and finds where it was meant to end (xml_slips.hpp).
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "script/xml/xml_slips.hpp"

namespace parlour::script {

enum class TagKind : unsigned char { start, empty, end, other };

struct ScannedTag {
  TagKind kind = TagKind::other; // comments, instructions, a lone '<'
  std::string_view name;
  std::size_t end = 0; // behind it
  // Where one of its slips has no correction, nobody knows what was meant:
  // then none of them has, and its end may be elsewhere.
  bool is_certain = true;
};

// The tag that begins with the '<' at `offset`.
ScannedTag scan_tag(std::string_view text, std::size_t offset,
                    std::vector<XmlSlip>& slips);

// Whether elements of that name hold nothing, wherever they stand.
bool holds_nothing(std::string_view name);

} // namespace parlour::script
