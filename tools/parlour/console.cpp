#include "tools/parlour/console.hpp"

#include <ostream>

namespace parlour::tools {

void say_error(const Console& console, std::string_view message) {
  console.err << coloured(console, red, "error:") << ' ' << message
              << std::endl;
}

void say_warning(const Console& console, std::string_view message) {
  console.err << coloured(console, yellow, "warning:") << ' ' << message
              << std::endl;
}

std::string coloured(const Console& console, const char* code,
                     std::string_view text) {
  if (!console.colour)
    return std::string(text);
  return std::string("\033[") + code + "m" + std::string(text) + "\033[0m";
}

} // namespace parlour::tools
