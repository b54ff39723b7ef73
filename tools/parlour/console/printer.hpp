// Printer: lines for standard output and standard error, in the order in which
// they were added, written by a thread of its own: a reader that has stopped
// reading holds up neither who speaks nor who notes.
#pragma once

#include <cstddef>
#include <functional>
#include <iosfwd>
#include <memory>
#include <string>

#include "runtime/base/clock.hpp"

namespace parlour::tools {

// Waiting to be written: where who makes lines should rest, and where nobody
// can be reading any more. In bytes.
inline constexpr std::size_t room_to_write = 64 * 1024;
inline constexpr std::size_t most_to_write = 16 * 1024 * 1024;
// What is written after it was given up.
inline constexpr Milliseconds last_lines_time{1'000};

class Printer {
public:
  // `closed` is called once, on the thread that writes or adds, when a line
  // could not be written to `out` or too much waits. What comes later for `out`
  // is left out. The streams must outlive what finish() leaves behind.
  Printer(std::ostream& out, std::ostream& err, std::function<void()> closed);
  Printer(const Printer&) = delete;
  Printer& operator=(const Printer&) = delete;
  ~Printer(); // finishes

  // A line, without its end. From any thread, and at once.
  void out(std::string line);
  void err(std::string line);

  // Until less waits than room_to_write, or it was given up.
  void wait_for_room();
  // Until all is written: true. False where it was given up, and what was left
  // is not written in the last lines' time: a thread still hangs in a stream.
  // Nothing may be added afterwards.
  bool finish();
  // From any thread: nobody waits for a reader any longer.
  void give_up();

private:
  struct State;
  std::shared_ptr<State> state_; // shared with the thread that writes
};

} // namespace parlour::tools
