// The one program: hands the process's streams and arguments to command_line.
#include <clocale>
#include <csignal>
#include <cstdlib>
#include <iostream>

#include <fcntl.h>
#include <unistd.h>

#include "tools/parlour/command_line.hpp"
#include "tools/parlour/exit_code.hpp"

namespace {

// A standard stream that is closed would be the next file opened, such as the
// database, and the robot's words would be written into it.
void open_standard_streams() {
  for (const auto descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (fcntl(descriptor, F_GETFD) < 0)
      (void)!open("/dev/null", O_RDWR); // takes the lowest free number
}

// Until somebody watches for signals nothing has begun that would have to be
// ended in order.
void end_at_once(int) {
  _exit(parlour::tools::exit_code::interrupted);
}

void watch_signals() {
  for (const auto number : {SIGINT, SIGTERM}) {
    struct sigaction action {};
    sigaction(number, nullptr, &action);
    if (action.sa_handler == SIG_IGN)
      continue;
    action.sa_handler = &end_at_once;
    sigaction(number, &action, nullptr);
  }
}

} // namespace

int main(int count, char** arguments) {
  watch_signals();
  open_standard_streams();
  // Characters on a terminal; numbers stay as they are written everywhere.
  std::setlocale(LC_CTYPE, "C.UTF-8");
  const auto* no_colour = std::getenv("NO_COLOR");
  const parlour::tools::Console console{std::cout, std::cerr,
                                        isatty(STDERR_FILENO) != 0 &&
                                            (!no_colour || !*no_colour)};
  return parlour::tools::run_command_line({arguments + 1, arguments + count},
                                          parlour::tools::process_places(),
                                          console);
}
