// The values that session variables begin with, as far as every session begins
// with the same. They are computed once for a program; a session makes its copy
// when a script first looks at the variable, so variables that nobody uses cost
// neither time nor memory.
#pragma once

#include <cstddef>
#include <functional>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "runtime/base/value.hpp"

namespace parlour::script {

// By their index in Program::variables; nothing for a variable whose value a
// session has to compute itself.
using KnownValues = std::vector<std::optional<Value>>;

// Belongs to a program; used by any thread.
class InitialValues {
public:
  // The first call computes them; others wait for it.
  const KnownValues& get(const std::function<KnownValues()>& compute) {
    std::call_once(once_, [&] { values_ = compute(); });
    return values_;
  }
  // Only after get().
  const Value& operator[](std::size_t variable) const {
    return *values_[variable];
  }
  bool has(std::size_t variable) const {
    return variable < values_.size() && values_[variable];
  }

private:
  std::once_flag once_;
  KnownValues values_;
};

} // namespace parlour::script
