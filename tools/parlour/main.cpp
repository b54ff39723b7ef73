// The program `parlour`: prepares the process (signals, standard streams,
// uncaught exceptions, locale) and hands its arguments to cli/command_line.
// Everything else is the library parlour_tools, which tests call directly.
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

// Opens /dev/null for each standard stream that is closed. Otherwise the next
// file opened, such as the database, would get its descriptor, and the robot's
// words would be written into that file. Standard output is opened for reading
// on purpose: printing to it still fails, as on a closed stream.
void open_standard_streams() {
  constexpr int ways[] = {O_RDONLY, O_RDONLY, O_RDWR};
  for (const auto descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (fcntl(descriptor, F_GETFD) < 0)
      (void)!open("/dev/null", ways[descriptor]); // takes the lowest free one
}

// Ctrl-C before a command watches signals itself (SignalWatch): nothing has
// begun yet that would have to be ended in order.
void end_at_once(int) {
  _exit(parlour::tools::exit_code::interrupted);
}

// Installs the handler, unless the parent ignores SIGINT (nohup, background).
void watch_signals() {
  // Beyond a file size limit (ulimit -f) a write then fails, like on a full
  // disk, instead of ending the process.
  signal(SIGXFSZ, SIG_IGN);
  struct sigaction action {};
  sigaction(SIGINT, nullptr, &action);
  if (action.sa_handler == SIG_IGN)
    return;
  action.sa_handler = &end_at_once;
  sigaction(SIGINT, &action, nullptr);
}

// Prints with write(): there may be no memory for a stream.
[[noreturn]] void end_without(const char* what) {
  (void)!write(STDERR_FILENO, what, std::strlen(what));
  _exit(parlour::tools::exit_code::wrong);
}

// The terminate handler, for an exception that nobody caught on any thread. If
// the system ran out of memory, threads or descriptors, says so and exits with
// status 1. Anything else is a bug and leaves a core.
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

// Standard output. It is tied to standard error: what was printed before an
// error appears before it. It is never destroyed, because std::cerr uses it
// until the process ends.
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
  // Only LC_CTYPE: wide characters on a terminal work, while numbers are
  // printed and parsed the same everywhere.
  std::setlocale(LC_CTYPE, "C.UTF-8");
  // Colour only on a terminal, and not where NO_COLOR is set (no-color.org).
  const auto* no_colour = std::getenv("NO_COLOR");
  auto& out = standard_output();
  const parlour::tools::Console console{
      out, std::cerr, isatty(STDERR_FILENO) != 0 && (!no_colour || !*no_colour),
      [&out] { return out.trouble(); },
      isatty(STDOUT_FILENO) != 0 && isatty(STDERR_FILENO) != 0};
  return parlour::tools::run_command_line({arguments + 1, arguments + count},
                                          parlour::tools::process_places(),
                                          console);
}
