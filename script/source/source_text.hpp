// SourceText: the text of one file. It translates between line and column,
// offsets in bytes of the file, and positions inside of attribute values.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include "script/source/source.hpp"

namespace parlour::script {

class TextPositions;

// Bytes [begin, end) of a file.
struct TextRange {
  std::size_t begin = 0;
  std::size_t end = 0;

  bool operator==(const TextRange&) const = default;
};

// Owns the text. Line starts are computed at the first question, so a file
// without findings costs nothing. Not thread-safe.
class SourceText {
public:
  explicit SourceText(std::string text);
  SourceText(SourceText&&) noexcept;
  SourceText& operator=(SourceText&&) noexcept;
  ~SourceText();

  const std::string& text() const {
    return text_;
  }
  // Translations between offsets and positions; both are clamped to the text.
  std::size_t offset_of(Position position) const;
  Position at(std::size_t offset) const;

  // The offset of byte `skip` of a value whose first character is at `start`.
  // The value is what the parser made of the file: entities replaced and each
  // line end one byte. With `collapsed`, runs of blanks count once, as in
  // script::collapsed, and comments inside count nothing.
  std::size_t inside(std::size_t start, std::size_t skip, bool collapsed) const;

  // The end of what should be underlined at this offset: a tag up to its name,
  // a whole attribute value, a word, or one character.
  std::size_t end_of(std::size_t begin) const;

private:
  const TextPositions& positions() const;

  std::string text_;
  std::size_t mark_ = 0; // length of a byte order mark
  mutable std::unique_ptr<TextPositions> positions_; // made when first needed
};

} // namespace parlour::script
