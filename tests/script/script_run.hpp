// One run of a script's `main`, as `parlour exec` would run it, in a time that
// only its waits move.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "runtime/base/files.hpp"
#include "script/program.hpp"

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

ScriptRun run_script(const std::shared_ptr<const script::Program>& program,
                     std::uint64_t instructions = run_instructions,
                     const FileAccess& files = {});

// The same, but nothing of its interpreter lives on between two steps: at every
// loop, call and wait its state is written to bytes, and a new interpreter goes
// on from them. What differs afterwards is an error of line 0.
ScriptRun
run_with_restores(const std::shared_ptr<const script::Program>& program,
                  std::uint64_t instructions = run_instructions,
                  const FileAccess& files = {});

} // namespace parlour::test
