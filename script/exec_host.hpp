// `parlour exec`: the language without the dialogue (language rule 7). Prints
// and logs go to the given sinks, timers and waits run in the order of their
// times, files are read and written at once; everything else is an error of
// kind Refused.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/base/files.hpp"
#include "script/interpreter.hpp"

namespace parlour::script {

struct ExecOptions {
  std::function<void(std::string_view)> print;
  std::function<void(std::string_view)> log;
  std::function<Timestamp()> now;
  // Returns at or after this time. Tests move a clock of their own.
  std::function<void(Timestamp)> wait_until;
  // Empty: there are no files, and statements that want them are refused.
  FileAccess files = {};
  std::uint64_t seed = 1;
  std::uint64_t instructions = defaults::exec_instructions; // of one event
};

struct ExecFailure {
  Error error;
  std::vector<std::string> stack; // innermost first
};

// Initialises the session variables, runs `main` as one event, then what it
// left behind: timers. Nothing where all went well; the first error ends it.
std::optional<ExecFailure> run_main(std::shared_ptr<const Program> program,
                                    const ExecOptions& options);

} // namespace parlour::script
