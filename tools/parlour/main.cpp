// The one program: hands the process's streams and arguments to command_line.
#include <clocale>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <iostream>
#include <new>
#include <system_error>

#include <fcntl.h>
#include <unistd.h>

#include "tools/parlour/cli/command_line.hpp"
#include "tools/parlour/console/exit_code.hpp"
#include "tools/parlour/console/output_stream.hpp"

namespace {

// A standard stream that is closed would be the next file opened, such as the
// database, and the robot's words would be written into it. What is printed to
// one fails, as it would without this.
void open_standard_streams() {
  constexpr int ways[] = {O_RDONLY, O_RDONLY, O_RDWR};
  for (const auto descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (fcntl(descriptor, F_GETFD) < 0)
      (void)!open("/dev/null", ways[descriptor]); // takes the lowest free one
}

// Until somebody watches for signals nothing has begun that would have to be
// ended in order.
void end_at_once(int) {
  _exit(parlour::tools::exit_code::interrupted);
}

void watch_signals() {
  signal(SIGXFSZ, SIG_IGN); // a file that may not grow is one that is full
  struct sigaction action {};
  sigaction(SIGINT, nullptr, &action);
  if (action.sa_handler == SIG_IGN)
    return;
  action.sa_handler = &end_at_once;
  sigaction(SIGINT, &action, nullptr);
}

[[noreturn]] void end_without(const char* what) {
  (void)!write(STDERR_FILENO, what, std::strlen(what));
  _exit(parlour::tools::exit_code::wrong);
}

// An exception that nobody caught, on whatever thread: what the system did not
// give is told, all else is a bug and leaves a core.
[[noreturn]] void end_by_exception() {
  try {
    if (const auto thrown = std::current_exception())
      std::rethrow_exception(thrown);
  } catch (const std::system_error&) {
    end_without("error: the system gives no more threads or descriptors\n");
  } catch (const std::bad_alloc&) {
    end_without("error: the system gives no more memory\n");
  } catch (...) {
    std::abort();
  }
  std::abort();
}

// Standard error shows what was printed before it first, as long as it is
// there: until the end.
parlour::tools::OutputStream& standard_output() {
  static auto& stream = *new parlour::tools::OutputStream(stdout);
  std::cerr.tie(&stream);
  return stream;
}

} // namespace

int main(int count, char** arguments) {
  std::set_terminate(&end_by_exception);
  watch_signals();
  open_standard_streams();
  // Characters on a terminal; numbers stay as they are written everywhere.
  std::setlocale(LC_CTYPE, "C.UTF-8");
  const auto* no_colour = std::getenv("NO_COLOR");
  auto& out = standard_output();
  const parlour::tools::Console console{
      out, std::cerr, isatty(STDERR_FILENO) != 0 && (!no_colour || !*no_colour),
      [&out] { return out.trouble(); }};
  return parlour::tools::run_command_line({arguments + 1, arguments + count},
                                          parlour::tools::process_places(),
                                          console);
}
