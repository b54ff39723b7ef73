// TextPositions: from an offset in a source text to its line and column
// (counted in code points; language rule 1.3).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "script/source/source.hpp"

namespace parlour::script {

class TextPositions {
public:
  // The text must outlive this. A line ends with LF, CR LF or CR.
  TextPositions(std::string_view text, std::uint16_t file);

  // Quickest in the order of the text.
  Position at(std::size_t offset) const;
  // The offset of a line's column; the text's end where there is none.
  std::size_t offset_of(std::uint32_t line, std::uint32_t column) const;

private:
  std::string_view text_;
  std::uint16_t file_;
  bool is_ascii_;
  std::vector<std::size_t> starts_; // of the lines
  // Where it was asked for last.
  mutable std::size_t line_ = 0;
  mutable std::size_t offset_ = 0;
  mutable std::size_t column_ = 0; // code points before it
};

// The offset of the first control character that is no white space, if any.
std::optional<std::size_t> find_control_character(std::string_view text);

} // namespace parlour::script
