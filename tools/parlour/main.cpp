// The one program: hands the process's streams and arguments to command_line.
#include <clocale>
#include <cstdlib>
#include <iostream>

#include <unistd.h>

#include "tools/parlour/command_line.hpp"

int main(int count, char** arguments) {
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
