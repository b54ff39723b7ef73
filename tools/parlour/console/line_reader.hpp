// LineReader: bytes of somebody's input to lines of well-formed text, whatever
// the bytes are. Holds at most one line of `longest_line` characters.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace parlour::tools {

inline constexpr std::size_t longest_line = 100'000; // characters

struct Line {
  std::string text;      // without its end, LF or CR LF
  bool repaired = false; // bytes that are no text became U+FFFD
  bool cut = false;      // the rest of a longer line is lost
};

class LineReader {
public:
  // Takes bytes up to the end of a line, at most all of them, away from
  // `bytes`; a line where one ended.
  std::optional<Line> take(std::string_view& bytes);

  // At the end of input: what came after the last line's end.
  std::optional<Line> finish();

  // A line has begun and not ended.
  bool in_line() const {
    return begun_;
  }

private:
  void add(char byte);
  void add_replacement();
  void count_character();
  void flush_sequence();
  Line give();

  Line line_;
  std::size_t characters_ = 0;
  std::string sequence_; // of a character that is not complete
  bool begun_ = false;
};

// Nothing but blanks.
bool is_blank(std::string_view text);

} // namespace parlour::tools
