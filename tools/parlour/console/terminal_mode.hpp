// The mode of the terminal that a component changes for a while: it is put back
// where the process ends and no destructor does so.
#pragma once

namespace parlour::tools {

// Remembers the mode, if there is a terminal, for end_now() and for SIGINT and
// SIGTERM where they end the process. For the first thread, before there are
// others that might change it.
void keep_terminal_mode(int descriptor);

// Ends the process without destructors. From any thread.
[[noreturn]] void end_now(int status);

} // namespace parlour::tools
