// What the program's exit status says (docs/running.md, "Exit status").
#pragma once

namespace parlour::tools::exit_code {

inline constexpr int well = 0;
// Something is wrong inside an application or a file, or what is printed
// cannot be written.
inline constexpr int wrong = 1;
// Wrong usage, or an application or file that does not exist.
inline constexpr int usage = 2;
// Ended by Ctrl-C. A request to terminate (SIGTERM, SIGHUP) that ended all in
// order is no failure, and otherwise the signal itself is the status.
inline constexpr int interrupted = 130;
// Nobody reads what is printed any more: what SIGPIPE is to a shell.
inline constexpr int nobody_reads = 141;

} // namespace parlour::tools::exit_code
