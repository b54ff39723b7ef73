#include "tests/script/script_run.hpp"

#include <algorithm>

#include "script/exec_host.hpp"

namespace parlour::test {

ScriptRun run_script(const std::shared_ptr<const script::Program>& program,
                     std::uint64_t instructions, const FileAccess& files) {
  ScriptRun run;
  Timestamp clock = 1'795'251'600'000; // 2026-11-21 09:00 UTC
  script::ExecOptions options;
  options.print = [&](std::string_view text) {
    run.printed.append(text) += '\n';
  };
  options.log = [](std::string_view) {};
  options.now = [&] { return clock; };
  options.wait_until = [&](Timestamp time) { clock = std::max(clock, time); };
  options.instructions = instructions;
  options.files = files;
  if (const auto failure = script::run_main(program, options))
    run.errors.push_back(
        {failure->error.place.line, std::string(name_of(failure->error.kind)) +
                                        ": " + failure->error.message});
  return run;
}

} // namespace parlour::test
