// One workload in our own language: a script with a constant `operations` and
// a function `work`.
#pragma once

#include <filesystem>
#include <memory>

#include "runtime/base/error.hpp"
#include "script/program/program.hpp"
#include "tools/bench/support/measure.hpp"

namespace parlour::tools {

class ScriptWorkload {
public:
  // The error names the first finding.
  static Expected<ScriptWorkload> load(const std::filesystem::path& file);

  // Calls `work` in a fresh interpreter. A wait is resumed at once.
  Expected<Measured> run() const;

  // Bytes that one activation of `work` holds while it waits, of many.
  Expected<double> suspended_bytes() const;

private:
  explicit ScriptWorkload(std::shared_ptr<const script::Program> program)
      : program_(std::move(program)) {}

  std::shared_ptr<const script::Program> program_;
};

} // namespace parlour::tools
