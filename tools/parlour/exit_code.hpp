// What the program's exit status says (docs/running.md, "Exit status").
#pragma once

namespace parlour::tools::exit_code {

inline constexpr int well = 0;
// Something is wrong inside an application or a file.
inline constexpr int wrong = 1;
// Wrong usage, or an application or file that does not exist.
inline constexpr int usage = 2;
// Ended by Ctrl-C or a request to terminate.
inline constexpr int interrupted = 130;

} // namespace parlour::tools::exit_code
