// TextPositions: translates between offsets in a text and lines and columns
// (counted in code points; language rule 1.3).
//
// Offsets count bytes, columns count characters as editors do; a text in ASCII
// needs no counting.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "script/source/source.hpp"

namespace parlour::script {

// Finds the line starts once; a question then costs a binary search, or less if
// questions come in the order of the text. Not thread-safe: it remembers the
// last answer.
class TextPositions {
public:
  // The text must outlive this object. A line ends with LF, CR LF or CR.
  TextPositions(std::string_view text, std::uint16_t file);

  // Fastest for offsets in ascending order.
  Position at(std::size_t offset) const;
  // The offset of a column in a line; the text's end if it does not exist.
  std::size_t offset_of(std::uint32_t line, std::uint32_t column) const;

private:
  std::string_view text_;
  std::uint16_t file_;
  bool is_ascii_;
  std::vector<std::size_t> starts_; // offsets at which the lines begin
  // The last answer, from which the next one is counted.
  mutable std::size_t line_ = 0;
  mutable std::size_t offset_ = 0;
  mutable std::size_t column_ = 0; // code points of the line before it
};

// The offset of the first control character other than white space, if any.
std::optional<std::size_t> find_control_character(std::string_view text);

} // namespace parlour::script
