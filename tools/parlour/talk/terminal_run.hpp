// A conversation on a terminal: lines with editing and history; what the robot
// says appears above the line that is being written.
#pragma once

#include <cstdio>
#include <deque>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "tools/parlour/talk/text_run.hpp"

namespace parlour::tools {

// Both ends of one terminal, and a descriptor that ends reading when it becomes
// readable. Owns none of them.
struct Terminal {
  std::FILE* in;
  std::FILE* out;
  int interrupt;
};

// What is on the terminal. say and note may be called from any thread; the rest
// from one.
class Screen {
public:
  // Lines written are kept in the file `history`, but for those of which
  // `is_private`, when all is over.
  using IsPrivate = std::function<bool(const std::string& line)>;
  Screen(const Terminal& terminal, std::filesystem::path history, bool colour,
         IsPrivate is_private = {});
  Screen(const Screen&) = delete;
  Screen& operator=(const Screen&) = delete;
  ~Screen();

  void say(const std::string& text);  // the robot's words
  void note(const std::string& text); // what is happening
  // Shows what was said and noted since.
  void flush();

  // A line without its end; nothing at the end of input or when interrupted.
  std::optional<std::string> read_line();

private:
  struct Editor;

  void add(std::string line);

  std::mutex mutex_;
  std::deque<std::string> lines_;
  bool colour_;
  std::unique_ptr<Editor> editor_;
};

// Each line is a turn; an empty line lets virtual time go to the next due
// timer. Until the input ends or is interrupted.
void talk_on_terminal(Partner& partner, Screen& screen);

} // namespace parlour::tools
