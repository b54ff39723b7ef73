// Console: the streams that a command reads from and writes to. The program
// passes the streams of the process, a test passes string streams. Commands
// never use std::cout or std::cerr, so tests can call them as functions.
#pragma once

#include <functional>
#include <iosfwd>
#include <string>
#include <string_view>

namespace parlour::tools {

// A struct of references: the streams must outlive it.
struct Console {
  std::ostream& out;
  std::ostream& err;
  bool colour = false; // use colours on `err`
  // The errno of the first failed write to `out`; 0 if none, or not known.
  std::function<int()> trouble = [] { return 0; };
  // Both are a terminal, on which a line may be drawn again and again.
  bool redraws = false;
};

// Prints "error: message" as a line on `err`, in red if colours are used.
void say_error(const Console& console, std::string_view message);
// Prints "warning: message", in yellow.
void say_warning(const Console& console, std::string_view message);

// The exit status of a command that has printed its result: `status`, or a
// failure if `out` could not be written. That is reported on `err`, except if
// the reader has gone away (EPIPE), as in `parlour … | head`. Flushes `out`.
int status_of_printing(const Console& console, int status);

// The text within the escape sequences for a colour, or unchanged if the
// console has no colours. `code` is one of the constants below.
std::string coloured(const Console& console, const char* code,
                     std::string_view text);

// SGR codes of ANSI terminals.
inline constexpr const char* red = "31";
inline constexpr const char* green = "32";
inline constexpr const char* yellow = "33";
inline constexpr const char* grey = "90";

} // namespace parlour::tools
