// InterpreterPool: interpreters for scripts that only compute and belong to no
// session: phrases, the conditions of routes. They see the program's constants,
// and are kept, so that these are computed once. Safe from any thread.
#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include "script/vm/interpreter.hpp"

namespace parlour::script {

class InterpreterPool {
public:
  explicit InterpreterPool(std::shared_ptr<const Program> program);

  // Runs it to the end as an event of its own. Constants that cannot be
  // computed are unknown: the session, which has them too, reports that.
  Expected<Value> evaluate(CodeId code, const std::vector<Value>& arguments,
                           ActivationContext context, Host& host) const;

  const Program& program() const {
    return *program_;
  }

private:
  std::unique_ptr<Interpreter> take(Host& host) const;

  const std::shared_ptr<const Program> program_;
  mutable std::mutex mutex_;
  mutable std::vector<std::unique_ptr<Interpreter>> free_;
};

} // namespace parlour::script
