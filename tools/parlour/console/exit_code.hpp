// The exit statuses of the program (docs/running.md, "Exit status").
#pragma once

namespace parlour::tools::exit_code {

inline constexpr int success = 0;
// An application or file has errors, a test failed, or the output could not be
// written.
inline constexpr int wrong = 1;
// Wrong usage, or there is no such application or file.
inline constexpr int usage = 2;
// Ended by Ctrl-C: 128 + SIGINT, as shells expect. After SIGTERM or SIGHUP a
// run ends in order with `success`; if it cannot, the signal itself is the
// status.
inline constexpr int interrupted = 130;
// The reader of our output has gone away: 128 + SIGPIPE.
inline constexpr int nobody_reads = 141;

// The same for `parlour --help`.
inline constexpr const char* statuses =
    "Exit status: 0 well, also where SIGTERM or SIGHUP has ended a run in "
    "order; 1\nsomething is wrong inside an application or file, or what is "
    "printed cannot be\nwritten; 2 wrong usage, or there is no such "
    "application or file; 130 after Ctrl-C;\n141 nobody reads what is "
    "printed.";

} // namespace parlour::tools::exit_code
