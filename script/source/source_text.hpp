// SourceText: one file as it was read, for places inside of attributes and for
// what a finding underlines. Offsets count the bytes of the file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include "script/source/source.hpp"

namespace parlour::script {

class TextPositions;

// Bytes of a file, from `begin` up to `end`.
struct TextRange {
  std::size_t begin = 0;
  std::size_t end = 0;

  bool operator==(const TextRange&) const = default;
};

class SourceText {
public:
  explicit SourceText(std::string text);
  SourceText(SourceText&&) noexcept;
  SourceText& operator=(SourceText&&) noexcept;
  ~SourceText();

  const std::string& text() const {
    return text_;
  }
  std::size_t offset_of(Position position) const;
  Position at(std::size_t offset) const;

  // Where the byte `skip` of a value stands that begins at `start`. The value
  // is what the parser made of the file: entities replaced, line ends as one
  // byte; with `collapsed`, blanks too as script::collapsed does, and comments
  // inside of it gone.
  std::size_t inside(std::size_t start, std::size_t skip, bool collapsed) const;

  // The end of what a reader would point at there: a tag with its name, a
  // whole value behind its quote, a word, or one character.
  std::size_t end_of(std::size_t begin) const;

private:
  const TextPositions& positions() const;

  std::string text_;
  std::size_t mark_ = 0; // bytes of a byte order mark
  mutable std::unique_ptr<TextPositions> positions_; // made when first needed
};

} // namespace parlour::script
