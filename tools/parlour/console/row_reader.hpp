// RowReader: groups piped input into rows of user turns (docs/running.md, "By
// lines").
//
// A row is a batch of turns that arrive together. It ends at an empty line, at
// the end of the input, or when no byte came for 50 ms. A very long row is
// delivered in parts, so that memory stays bounded. The class knows neither a
// clock nor a file: both are behind ByteSource, and tests use their own.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "runtime/base/clock.hpp"
#include "tools/parlour/console/line_reader.hpp"

namespace parlour::tools {

// The pause that ends a row.
inline constexpr Milliseconds row_pause{50};
// Beyond either limit a row is delivered in parts.
inline constexpr std::size_t longest_row = 1'000;           // turns
inline constexpr std::size_t longest_row_bytes = 1'000'000; // size of the turns

// The result of one read: bytes (perhaps none), or why there are none.
struct Read {
  enum class Kind : std::uint8_t { bytes, silence, end, interrupted };
  Kind kind = Kind::end;
  std::string bytes;
};

// Where the bytes come from: DescriptorSource, or a test's script.
class ByteSource {
public:
  virtual ~ByteSource() = default;
  // Blocks until bytes are there, but `patience` at most if it is given. Then
  // it returns Kind::silence.
  virtual Read read(std::optional<Milliseconds> patience) = 0;
};

// What the driver of a conversation is to do next (talk/text_run).
struct RowEvent {
  enum class Kind : std::uint8_t {
    turns,       // enter these turns together
    quiet,       // an empty line ended the row: wait until quiet
    step,        // a further empty line: step to the next due timer
    end,         // the input has ended
    interrupted, // a signal came
  };
  Kind kind = Kind::end;
  std::vector<std::string> turns;
  // Of `turns`: more of the same row follows; wait until quiet first.
  bool is_part = false;
};

class RowReader {
public:
  // Gets one line of text for each change to the input (invalid UTF-8, a line
  // that was cut, a row in parts), with the number of the input line.
  using Note = std::function<void(const std::string&)>;

  // `source` must outlive the reader.
  RowReader(ByteSource& source, Note note);

  // Blocks until there is an event.
  RowEvent next();

private:
  // Adds a line to the row, or ends the row if the line is empty.
  void take(Line line);
  void end_row();
  void end_part();
  void read_more();
  void read_rest(); // the source has ended

  ByteSource& source_;
  Note note_;
  LineReader lines_;
  std::vector<std::string> row_;
  std::size_t row_bytes_ = 0; // bytes in row_
  bool told_of_parts_ = false;
  std::deque<RowEvent> events_;
  std::uint64_t number_ = 0;
  // The last line was a turn, so the next empty line ends its row. That holds
  // even if a pause has delivered the row already: otherwise the meaning of the
  // empty line would depend on timing.
  bool after_turn_ = false;
};

} // namespace parlour::tools
