#include "tools/bench/script/state_bench.hpp"

#include "script/compiler/compiler.hpp"
#include "script/run/exec_run.hpp"
#include "tools/bench/support/measure.hpp"

namespace parlour::tools {

namespace {

// A run without output in which no time passes.
script::ExecOptions quiet() {
  script::ExecOptions options;
  options.print = [](std::string_view) {};
  options.log = [](std::string_view) {};
  options.now = [] { return Timestamp{0}; };
  options.wait_until = [](Timestamp) {};
  return options;
}

} // namespace

Expected<StateTimes> state_once(const std::filesystem::path& file) {
  const auto compiled = script::compile_file(file, {});
  if (!compiled.program)
    return fail(ErrorKind::compile,
                script::to_string(compiled.findings.all().front()));
  script::ExecRun run(compiled.program, quiet());
  // One slice is enough to reach the wait.
  run.set_slice(1'000'000);
  run.step();
  if (run.failure())
    return tl::make_unexpected(run.failure()->error);
  // The first save computes the identity of the program, which is then kept.
  run.save();
  StateTimes times;
  const auto start = cpu_nanoseconds();
  const auto bytes = run.save();
  const auto written = cpu_nanoseconds();
  const auto again = script::ExecRun::restore(compiled.program, quiet(), bytes);
  const auto read = cpu_nanoseconds();
  if (!again)
    return tl::make_unexpected(again.error());
  times.save = written - start;
  times.restore = read - written;
  times.bytes = bytes.size();
  return times;
}

} // namespace parlour::tools
