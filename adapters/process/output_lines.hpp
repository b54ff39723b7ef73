// OutputLines: what a process prints, as lines for the log: cut where they are
// long, and left out where there are too many.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <utility>

#include "runtime/base/clock.hpp"

namespace parlour::adapters {

// For one thread.
class OutputLines {
public:
  static constexpr std::size_t longest = 500; // bytes
  static constexpr int most_each_second = 20;

  using Print = std::function<void(const std::string& line)>;
  explicit OutputLines(Print print) : print_(std::move(print)) {}

  void add(std::string_view bytes, Timestamp now);
  // Nothing more comes: what is left of a line is one.
  void finish();

private:
  void add_piece(std::string_view piece);
  void end_line(Timestamp now);
  void tell_left_out();

  Print print_;
  std::string line_;
  bool is_cut_ = false;
  Timestamp second_ = 0; // in which `printed_` and `left_out_` were counted
  int printed_ = 0;
  std::size_t left_out_ = 0;
};

} // namespace parlour::adapters
