// Scripts that query a database component as sessions do: each waits for its
// answer, and all of them share one thread. Only the actors between script and
// component are missing.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>

#include "runtime/base/error.hpp"
#include "script/program/program.hpp"
#include "tools/bench/support/desk.hpp"
#include "tools/bench/support/measure.hpp"

namespace parlour::tools {

// Compiled once; may be run again and again.
class QueryWorkload {
public:
  // Compiles the workload. The error has the first finding.
  static Expected<QueryWorkload> load(const std::filesystem::path& file);

  // Runs `count` queries from `sessions` sessions at once. The component has
  // been started with `desk` as its host; `server` is the process of its
  // database, or 0. The result is the number of letters received. The error is
  // the first one of the component or of a script.
  Expected<Measured> run(IPlugin& component, Desk& desk, int server,
                         std::size_t sessions, std::size_t count) const;

private:
  explicit QueryWorkload(std::shared_ptr<const script::Program> program)
      : program_(std::move(program)) {}

  std::shared_ptr<const script::Program> program_;
};

} // namespace parlour::tools
