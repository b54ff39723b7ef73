// One run of a script's `main`, as `parlour exec` would run it, in a time that
// only its waits move.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "script/run/exec_run.hpp"

namespace parlour::test {

struct Remark {
  std::uint32_t line = 0;
  std::string text;

  bool operator==(const Remark&) const = default;
};

struct ScriptRun {
  std::string printed;
  std::vector<Remark> errors; // "Kind: message"

  bool operator==(const ScriptRun&) const = default;
};

// Instructions of one event.
inline constexpr std::uint64_t run_instructions = 1'000'000;

// What a run prints to, and the time that it is there. The options refer to it.
struct Stage {
  // A script may wait for ever: of later waits nothing is seen.
  static constexpr int most_waits = 200;

  std::string printed;
  Timestamp clock = 1'795'251'600'000; // 2026-11-21 09:00 UTC
  int waits = 0;

  bool is_over() const {
    return waits > most_waits;
  }
  script::ExecOptions options(std::uint64_t instructions, FileAccess files);
  // With the failure, if there was one.
  ScriptRun result(const script::ExecRun& run) const;
};

ScriptRun run_script(const std::shared_ptr<const script::Program>& program,
                     std::uint64_t instructions = run_instructions,
                     const FileAccess& files = {});

// The same, but nothing of it lives on between two steps: at every loop, call
// and wait it is written to bytes, and a new one goes on from them. What
// differs afterwards is an error of line 0.
ScriptRun
run_with_restores(const std::shared_ptr<const script::Program>& program,
                  std::uint64_t instructions = run_instructions,
                  const FileAccess& files = {});

// Which of its stops a run is restored at: `count` of them from the stop
// `first`. What comes before and after runs on.
struct RestoredStops {
  int first = 0;
  int count = 0;
};
ScriptRun
run_with_restores(const std::shared_ptr<const script::Program>& program,
                  std::uint64_t instructions, RestoredStops stops);

} // namespace parlour::test
