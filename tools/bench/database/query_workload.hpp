// Scripts that ask a database component, as sessions do: each of them waits for
// its answer, all of them on one thread. Everything but the actors in between.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>

#include "runtime/base/error.hpp"
#include "script/program/program.hpp"
#include "tools/bench/support/desk.hpp"
#include "tools/bench/support/measure.hpp"

namespace parlour::tools {

class QueryWorkload {
public:
  // The error names the first finding.
  static Expected<QueryWorkload> load(const std::filesystem::path& file);

  // `count` queries from so many sessions at once, of a component that was
  // started at this desk and may have a server. The result is how many letters
  // came. The first error of the component or of a script is told instead.
  Expected<Measured> run(IPlugin& component, Desk& desk, int server,
                         std::size_t sessions, std::size_t count) const;

private:
  explicit QueryWorkload(std::shared_ptr<const script::Program> program)
      : program_(std::move(program)) {}

  std::shared_ptr<const script::Program> program_;
};

} // namespace parlour::tools
