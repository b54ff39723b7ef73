// RowReader: piped input to rows of user turns (docs/running.md, "By lines"). A
// row ends at an empty line, at the end of input, or when no byte came for
// 50 ms; one that never ends is taken in parts, so that no more of it is held
// than that. Knows neither a clock nor a file: both are the ByteSource.
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

inline constexpr Milliseconds row_pause{50};
inline constexpr std::size_t longest_row = 1'000;           // turns
inline constexpr std::size_t longest_row_bytes = 1'000'000; // about

struct Read {
  enum class Kind : std::uint8_t { bytes, silence, end, interrupted };
  Kind kind = Kind::end;
  std::string bytes;
};

class ByteSource {
public:
  virtual ~ByteSource() = default;
  // Waits for bytes; at most `patience` where there is one.
  virtual Read read(std::optional<Milliseconds> patience) = 0;
};

struct RowEvent {
  enum class Kind : std::uint8_t {
    turns,       // a row: its turns arrive together
    quiet,       // the empty line that ends a row: wait until quiet
    step,        // a further empty line: time goes to the next due timer
    end,         // of input
    interrupted, // by a signal
  };
  Kind kind = Kind::end;
  std::vector<std::string> turns;
  // Of `turns`: the row goes on; wait until quiet before you read on.
  bool is_part = false;
};

class RowReader {
public:
  // `note` is told what was changed in a line, with the line's number.
  using Note = std::function<void(const std::string&)>;

  RowReader(ByteSource& source, Note note);

  RowEvent next();

private:
  void take(Line line);
  void end_row();
  void end_part();
  void read_more();
  void read_rest(); // of a source that has ended

  ByteSource& source_;
  Note note_;
  LineReader lines_;
  std::vector<std::string> row_;
  std::size_t row_bytes_ = 0;
  bool told_of_parts_ = false;
  std::deque<RowEvent> events_;
  std::uint64_t number_ = 0;
  // The last line was a turn: the next empty line ends its row, also where a
  // pause has ended it before, so that what happens hangs on no timing.
  bool after_turn_ = false;
};

} // namespace parlour::tools
