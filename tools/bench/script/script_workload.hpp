// A workload in the script language: a script with a constant `operations` and
// a function `work`.
//
//  <dialogue>
//    <const name="operations" expr="1000"/>
//    <function name="work">… <return expr="result"/></function>
//  </dialogue>
#pragma once

#include <filesystem>
#include <memory>

#include "runtime/base/error.hpp"
#include "script/program/program.hpp"
#include "tools/bench/support/measure.hpp"

namespace parlour::tools {

// Compiled once; may be run again and again.
class ScriptWorkload {
public:
  // Compiles the workload. The error has the first finding.
  static Expected<ScriptWorkload> load(const std::filesystem::path& file);

  // Calls `work` in a new interpreter. A script that waits is resumed at once.
  Expected<Measured> run() const;

  // The memory that one activation of `work` holds while it waits, as the
  // average of many.
  Expected<double> suspended_bytes() const;

private:
  explicit ScriptWorkload(std::shared_ptr<const script::Program> program)
      : program_(std::move(program)) {}

  std::shared_ptr<const script::Program> program_;
};

} // namespace parlour::tools
