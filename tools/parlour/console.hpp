// Console: where a command reads and writes. The program has the process's
// streams, a test has strings.
#pragma once

#include <iosfwd>
#include <string>
#include <string_view>

namespace parlour::tools {

struct Console {
  std::ostream& out;
  std::ostream& err;
  bool colour = false; // of what goes to `err`
};

// "error: message" as a line of `err`, red where there is colour.
void say_error(const Console& console, std::string_view message);
void say_warning(const Console& console, std::string_view message);

// The text between the escape sequences of a colour, or as it is.
std::string coloured(const Console& console, const char* code,
                     std::string_view text);

inline constexpr const char* red = "31";
inline constexpr const char* green = "32";
inline constexpr const char* yellow = "33";
inline constexpr const char* grey = "90";

} // namespace parlour::tools
