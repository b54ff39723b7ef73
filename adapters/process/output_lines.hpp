// OutputLines turns what a process prints into lines for the log. It shortens
// long lines and leaves lines out if there are too many, so that a component
// cannot flood the log.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <utility>

#include "runtime/base/clock.hpp"

namespace parlour::adapters {

// Not thread-safe.
class OutputLines {
public:
  // In bytes.
  static constexpr std::size_t longest = 500;
  static constexpr int max_each_second = 20;

  using Print = std::function<void(const std::string& line)>;
  explicit OutputLines(Print print) : print_(std::move(print)) {}

  // Adds what was printed. `now` is any clock in milliseconds that does not go
  // back.
  void add(std::string_view bytes, Timestamp now);
  // The output has ended: a last line without a line break is printed, too.
  void finish();

private:
  void add_piece(std::string_view piece);
  void end_line(Timestamp now);
  void tell_left_out();

  Print print_;
  std::string line_;
  bool is_cut_ = false;
  // The beginning of the second in which lines are being counted.
  Timestamp second_ = 0;
  int printed_ = 0;
  std::size_t left_out_ = 0;
};

} // namespace parlour::adapters
