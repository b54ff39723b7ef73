// A conversation on a terminal: a line editor with history (libedit), and
// output that appears above the line that is being typed.
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

// A terminal to read from and write to, and a descriptor that ends reading when
// it becomes readable (SignalWatch::descriptor). Owns none of them.
struct Terminal {
  std::FILE* in;
  std::FILE* out;
  int interrupt;
};

// The screen of a terminal. say(), note() and status() may be called from any
// thread; everything else from the thread that reads.
class Screen {
public:
  // Loads the history from the file `history`, and saves it there when the
  // screen is destroyed, without lines for which `is_private` is true (engine
  // rule 7.6). `colour` switches bold and grey on.
  using IsPrivate = std::function<bool(const std::string& line)>;
  Screen(const Terminal& terminal, std::filesystem::path history, bool colour,
         IsPrivate is_private = {});
  Screen(const Screen&) = delete;
  Screen& operator=(const Screen&) = delete;
  ~Screen();

  void say(const std::string& text);  // the robot's words, in bold
  void note(const std::string& text); // traces and errors, in grey
  // Shows a text before the prompt, in the place of the one before; an empty
  // one takes it away.
  void status(const std::string& text);
  // Prints the lines that were added since. read_line() does so while it waits;
  // call flush() when nobody reads any more.
  void flush();

  // Reads a line, without its end. Nothing at the end of the input (Ctrl-D) or
  // when interrupted.
  std::optional<std::string> read_line();

private:
  struct Editor; // libedit and its history

  // Queues a line and wakes the thread that reads.
  void add(std::string line);

  std::mutex mutex_;              // guards these two
  std::deque<std::string> lines_; // not printed yet
  std::string status_;            // before the prompt
  bool colour_;
  std::unique_ptr<Editor> editor_;
};

// Reads lines until the input ends or is interrupted. Each line is a user turn.
// In virtual time, an empty line lets time pass (let_time_pass) and the others
// are answered before the next is read; in real time the robot answers while
// the user types.
void talk_on_terminal(ConversationDriver& driver, Screen& screen);

} // namespace parlour::tools
