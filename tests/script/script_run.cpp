#include "tests/script/script_run.hpp"

#include <algorithm>

namespace parlour::test {

namespace {

using script::ExecRun;

// Later stops are further apart: a script that runs into a limit would stop a
// hundred thousand times.
constexpr int close_stops = 150;
constexpr std::uint64_t later_slice = 10'000;

// Saves the run and restores it; notes any difference.
std::unique_ptr<ExecRun>
restored(const ExecRun& run,
         const std::shared_ptr<const script::Program>& program,
         const script::ExecOptions& options, std::vector<Remark>& errors) {
  const auto bytes = run.save();
  auto again = ExecRun::restore(program, options, bytes);
  if (!again) {
    errors.push_back({0, again.error().message});
    return nullptr;
  }
  if ((*again)->save() != bytes)
    errors.push_back({0, "the restored state has other bytes"});
  if ((*again)->bytes_held() != run.bytes_held())
    errors.push_back({0, "the restored state holds other memory"});
  return std::move(*again);
}

} // namespace

script::ExecOptions Stage::options(std::uint64_t instructions,
                                   FileAccess files) {
  script::ExecOptions options;
  options.print = [this](std::string_view text) {
    if (!is_over())
      printed.append(text) += '\n';
  };
  options.log = [](std::string_view) {};
  options.now = [this] { return clock; };
  options.wait_until = [this](Timestamp time) {
    clock = std::max(clock, time);
    ++waits;
  };
  options.instructions = instructions;
  options.files = std::move(files);
  return options;
}

ScriptRun Stage::result(const ExecRun& run) const {
  ScriptRun result{printed, {}};
  if (const auto& failure = run.failure(); failure && !is_over())
    result.errors.push_back(
        {failure->error.place.line, std::string(name_of(failure->error.kind)) +
                                        ": " + failure->error.message});
  return result;
}

ScriptRun run_script(const std::shared_ptr<const script::Program>& program,
                     std::uint64_t instructions, const FileAccess& files) {
  Stage stage;
  ExecRun run(program, stage.options(instructions, files));
  while (!stage.is_over() && run.step()) {
  }
  return stage.result(run);
}

namespace {

// `close(stop)`: whether to stop after a single step. `restores(stop)`: whether
// to save and restore there.
template <typename Close, typename Restores>
ScriptRun run_stopping(const std::shared_ptr<const script::Program>& program,
                       std::uint64_t instructions, const FileAccess& files,
                       Close close, Restores restores) {
  Stage stage;
  const auto options = stage.options(instructions, files);
  auto run = std::make_unique<ExecRun>(program, options);
  std::vector<Remark> differences;
  for (int stop = 0;; ++stop) {
    run->set_slice(close(stop) ? 1 : later_slice);
    if (stage.is_over() || !run->step() || run->failure())
      break;
    if (!restores(stop))
      continue;
    auto next = restored(*run, program, options, differences);
    if (!next)
      break;
    run = std::move(next);
  }
  auto result = stage.result(*run);
  result.errors.insert(result.errors.end(), differences.begin(),
                       differences.end());
  return result;
}

} // namespace

ScriptRun
run_with_restores(const std::shared_ptr<const script::Program>& program,
                  std::uint64_t instructions, const FileAccess& files) {
  return run_stopping(
      program, instructions, files, [](int stop) { return stop < close_stops; },
      [](int) { return true; });
}

ScriptRun
run_with_restores(const std::shared_ptr<const script::Program>& program,
                  std::uint64_t instructions, RestoredStops stops) {
  const auto end = stops.first + stops.count;
  return run_stopping(
      program, instructions, {}, [end](int stop) { return stop < end; },
      [=](int stop) { return stop >= stops.first && stop < end; });
}

} // namespace parlour::test
