// LineReader: turns bytes into lines of valid UTF-8, whatever the bytes are.
// Pure; it keeps one line at most, cut at `longest_line` characters.
//
//   LineReader reader;
//   while (auto line = reader.take(bytes)) // a string_view, consumed
//     use(line->text);
//   if (auto line = reader.finish()) // the last line may lack its end
//     use(line->text);
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace parlour::tools {

inline constexpr std::size_t longest_line = 100'000; // characters

struct Line {
  std::string text;      // without its end (LF or CR LF)
  bool repaired = false; // invalid bytes became U+FFFD
  bool cut = false;      // the line was too long and was cut
};

class LineReader {
public:
  // Consumes bytes from the front of `bytes`, up to and including the next line
  // end. Returns the line, or nothing if all bytes were consumed before one.
  std::optional<Line> take(std::string_view& bytes);

  // At the end of the input: the last line, if it has no line end.
  std::optional<Line> finish();

  // Whether a line has begun that has not ended.
  bool in_line() const {
    return begun_;
  }

private:
  // Adds one byte; completes or rejects the UTF-8 sequence it belongs to.
  void add(char byte);
  void add_replacement();
  // Sets `cut` when the line has reached its limit.
  void count_character();
  // Ends an incomplete sequence: it becomes U+FFFD.
  void flush_sequence();
  // Returns the line and starts an empty one.
  Line give();

  Line line_;
  std::size_t characters_ = 0;
  std::string sequence_; // the bytes of an incomplete character
  bool begun_ = false;
};

// Whether there is nothing but white space.
bool is_blank(std::string_view text);

} // namespace parlour::tools
