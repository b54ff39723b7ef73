// Printer: writes lines to standard output and standard error in the order in
// which they were added, on a thread of its own. A reader that has stopped
// reading therefore blocks neither the conversation nor whoever logs.
//
// If too many lines wait, a producer should pause (wait_for_room). If far too
// many wait, the reader is treated as gone, as it is when a write fails.
#pragma once

#include <cstddef>
#include <functional>
#include <iosfwd>
#include <memory>
#include <string>

#include "runtime/base/clock.hpp"

namespace parlour::tools {

// Limits of the bytes that wait to be written. Above room_to_write,
// wait_for_room() blocks; above max_to_write, the reader is treated as gone.
inline constexpr std::size_t room_to_write = 65'536;
inline constexpr std::size_t max_to_write = 16'777'216;
// The time that finish() still grants after give_up().
inline constexpr Milliseconds last_lines_time{1'000};

class Printer {
public:
  // `closed` is called once, when the reader is gone: a write to `out` failed
  // or too many bytes wait. It runs on the writing thread or on the thread that
  // adds a line, without a lock held. Later lines for `out` are dropped; lines
  // for `err` are still written, as far as there is room. If finish() returns
  // false, the streams must live as long as the process, because the writing
  // thread still uses them.
  Printer(std::ostream& out, std::ostream& err, std::function<void()> closed);
  Printer(const Printer&) = delete;
  Printer& operator=(const Printer&) = delete;
  // Calls finish().
  ~Printer();

  // Adds a line, without its line end. Does not block; from any thread.
  void out(std::string line);
  void err(std::string line);

  // Shows a line below all others on a terminal, in the place of the one
  // before, until finish(); an empty one takes it away. From any thread. Only
  // for an `err` that is a terminal.
  void status(std::string line);

  // Blocks until fewer than room_to_write bytes wait, or give_up() was called.
  void wait_for_room();
  // Blocks until all lines are written, and returns true. After give_up() it
  // waits for last_lines_time at most; then it returns false if lines are left,
  // and the writing thread is detached, because it hangs in a write. Lines that
  // are added later are dropped.
  bool finish();
  // Stops waiting for the reader; from any thread.
  void give_up();

private:
  struct State;
  std::shared_ptr<State> state_; // shared with the writing thread
};

} // namespace parlour::tools
