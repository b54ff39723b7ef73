// A signal handler reads what is kept, so it is global, and put_back() calls
// nothing but what POSIX allows in one.
#include "tools/parlour/console/terminal_mode.hpp"

#include <atomic>
#include <cstdlib>

#include <signal.h>
#include <termios.h>

namespace parlour::tools {

namespace {

termios kept_mode;
std::atomic<int> kept_terminal = -1; // -1: nothing is kept

void put_back() {
  if (const int terminal = kept_terminal; terminal >= 0)
    tcsetattr(terminal, TCSANOW, &kept_mode);
}

// The signal that is raised comes when the handler returns.
void end_by_signal(int number) {
  put_back();
  signal(number, SIG_DFL);
  raise(number);
}

} // namespace

void keep_terminal_mode(int descriptor) {
  if (tcgetattr(descriptor, &kept_mode) != 0)
    return;
  kept_terminal = descriptor;
  for (const int number : {SIGINT, SIGTERM}) {
    struct sigaction action {};
    if (sigaction(number, nullptr, &action) == 0 &&
        action.sa_handler != SIG_IGN)
      signal(number, end_by_signal);
  }
}

void end_now(int status) {
  put_back();
  std::_Exit(status);
}

} // namespace parlour::tools
