// Reads a single tag of a text that need not be well-formed, reports its
// mistakes, and finds where it was meant to end. xml_mistakes.hpp uses it for a
// whole text.
//
// The scanner goes from attribute to attribute and, at each mistake, decides
// where the author's intention continues, so that one mistake does not hide the
// next:
//
//   <speak param="x>              no closing quote: the tag ends at the line's
//                                 last '>'
//   <speak param=x>               a value without quotes: up to the next blank
//   <speak param=“x”>             typographic quotes: up to the closing one
//   <speak param="say "x" now">   more follows the value: it has quotes inside
//   <speak "x">                   a value without a name
//   <speak param="x"              no '>': the next '<' begins a new tag
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "script/xml/xml_mistakes.hpp"

namespace parlour::script {

enum class TagKind : unsigned char { start, empty, end, other };

struct ScannedTag {
  TagKind kind = TagKind::other; // comment, instruction, lone '<'
  std::string_view name;
  std::size_t end = 0; // offset behind the tag
  // False if a mistake in the tag has no correction. Then it is unknown what
  // was meant: no mistake of the tag keeps its correction, and the tag may end
  // elsewhere.
  bool is_certain = true;
};

// Reads the tag whose '<' is at `offset` and appends its mistakes.
ScannedTag scan_tag(std::string_view text, std::size_t offset,
                    std::vector<XmlMistake>& mistakes);

// Whether elements of that name are always empty, wherever they may stand.
bool holds_nothing(std::string_view name);

} // namespace parlour::script
