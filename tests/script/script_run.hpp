// Runs the function main of a script as `parlour exec` does, but in virtual
// time.
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

// The limit of instructions for one event.
inline constexpr std::uint64_t run_instructions = 1'000'000;

// The effects of a run: what it prints, and its clock. The options refer to
// this object.
struct Stage {
  // A script may wait for ever, so what happens after so many waits is ignored.
  static constexpr int max_waits = 200;

  std::string printed;
  Timestamp clock = 1'795'251'600'000; // 2026-11-21 09:00 UTC
  int waits = 0;

  bool is_over() const {
    return waits > max_waits;
  }
  script::ExecOptions options(std::uint64_t instructions, FileAccess files);
  // The result, with the failure if there was one.
  ScriptRun result(const script::ExecRun& run) const;
};

ScriptRun run_script(const std::shared_ptr<const script::Program>& program,
                     std::uint64_t instructions = run_instructions,
                     const FileAccess& files = {});

// Like run_script, but at every loop, call and wait the run is saved and a
// restored one continues. If anything differs, the result has an error at line
// 0.
ScriptRun
run_with_restores(const std::shared_ptr<const script::Program>& program,
                  std::uint64_t instructions = run_instructions,
                  const FileAccess& files = {});

// Restores only at `count` stops, starting with the stop `first`.
struct RestoredStops {
  int first = 0;
  int count = 0;
};
ScriptRun
run_with_restores(const std::shared_ptr<const script::Program>& program,
                  std::uint64_t instructions, RestoredStops stops);

} // namespace parlour::test
