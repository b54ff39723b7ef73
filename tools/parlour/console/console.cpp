#include "tools/parlour/console/console.hpp"

#include <cerrno>
#include <cstring>
#include <ostream>

#include "tools/parlour/console/exit_code.hpp"

namespace parlour::tools {

void say_error(const Console& console, std::string_view message) {
  console.err << coloured(console, red, "error:") << ' ' << message
              << std::endl;
}

void say_warning(const Console& console, std::string_view message) {
  console.err << coloured(console, yellow, "warning:") << ' ' << message
              << std::endl;
}

// If the command failed anyway, its own status says more than a full disk.
int status_of_printing(const Console& console, int status) {
  if (console.out.flush())
    return status;
  const auto why = console.trouble();
  const bool nobody_reads = why == EPIPE;
  if (!nobody_reads)
    say_error(console, "what is printed cannot be written" +
                           (why ? std::string(": ") + std::strerror(why) : ""));
  if (status != exit_code::success)
    return status;
  return nobody_reads ? exit_code::nobody_reads : exit_code::wrong;
}

std::string coloured(const Console& console, const char* code,
                     std::string_view text) {
  if (!console.colour)
    return std::string(text);
  return std::string("\033[") + code + "m" + std::string(text) + "\033[0m";
}

} // namespace parlour::tools
