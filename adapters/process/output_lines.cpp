#include "adapters/process/output_lines.hpp"

#include <utility>

#include "runtime/base/text/utf8.hpp"

namespace parlour::adapters {

namespace {

// Replaces control characters, which a terminal would obey, and invalid UTF-8.
std::string plain(std::string line) {
  for (auto& byte : line)
    if (static_cast<unsigned char>(byte) < ' ' || byte == '\x7f')
      byte = ' ';
  while (const auto invalid = find_invalid_utf8(line))
    line[*invalid] = '?';
  return line;
}

} // namespace

// The last piece may be the beginning of a line that goes on with the next
// call.
void OutputLines::add(std::string_view bytes, Timestamp now) {
  for (auto end = bytes.find('\n'); end != std::string_view::npos;
       end = bytes.find('\n')) {
    add_piece(bytes.substr(0, end));
    end_line(now);
    bytes.remove_prefix(end + 1);
  }
  add_piece(bytes);
}

// Keeps the beginning of the line only.
void OutputLines::add_piece(std::string_view piece) {
  const auto room = longest - line_.size();
  is_cut_ |= piece.size() > room;
  line_ += piece.substr(0, room);
}

// The first line after a second starts a new count and reports what was left
// out. Blank lines are not counted.
void OutputLines::end_line(Timestamp now) {
  if (now - second_ >= 1'000) {
    tell_left_out();
    second_ = now;
    printed_ = 0;
  }
  auto line = std::exchange(line_, {});
  const bool cut = std::exchange(is_cut_, false);
  if (line.find_first_not_of(" \t\r") == std::string::npos)
    return;
  if (printed_ == max_each_second) {
    ++left_out_;
    return;
  }
  ++printed_;
  print_(plain(std::move(line)) + (cut ? " …" : ""));
}

void OutputLines::tell_left_out() {
  if (left_out_ != 0)
    print_("(lines left out: " + std::to_string(left_out_) + ")");
  left_out_ = 0;
}

void OutputLines::finish() {
  end_line(second_);
  tell_left_out();
}

} // namespace parlour::adapters
