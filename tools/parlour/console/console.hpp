// Console: where a command reads and writes. The program has the process's
// streams, a test has strings.
#pragma once

#include <functional>
#include <iosfwd>
#include <string>
#include <string_view>

namespace parlour::tools {

struct Console {
  std::ostream& out;
  std::ostream& err;
  bool colour = false; // of what goes to `err`
  // The errno of a write to `out` that failed; 0 where that is not known.
  std::function<int()> trouble = [] { return 0; };
};

// "error: message" as a line of `err`, red where there is colour.
void say_error(const Console& console, std::string_view message);
void say_warning(const Console& console, std::string_view message);

// The exit status of a command that has printed: `status`, unless `out` could
// not be written. That is said, but where nobody reads it any more.
int status_of_printing(const Console& console, int status);

// The text between the escape sequences of a colour, or as it is.
std::string coloured(const Console& console, const char* code,
                     std::string_view text);

inline constexpr const char* red = "31";
inline constexpr const char* green = "32";
inline constexpr const char* yellow = "33";
inline constexpr const char* grey = "90";

} // namespace parlour::tools
