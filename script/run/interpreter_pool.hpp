// InterpreterPool: interpreters for code that only computes and belongs to no
// session, such as phrases and conditions of routes. Each interpreter has
// computed the program's constants, so the pool keeps interpreters for reuse:
// those that are still as they began. Nothing therefore passes from one
// evaluation to the next (architecture rule 1). Safe from any thread.
#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include "script/vm/interpreter.hpp"

namespace parlour::script {

// As many interpreters are made as threads compute at the same time.
class InterpreterPool {
public:
  explicit InterpreterPool(std::shared_ptr<const Program> program);

  // Runs the code to its end, as an event of its own. Session variables have
  // their initial values; what a function sets is gone afterwards. A constant
  // that cannot be computed is unknown here; sessions, which have it too,
  // report the error.
  Expected<Value> evaluate(CodeId code, const std::vector<Value>& arguments,
                           ActivationContext context, Host& host) const;

  const Program& program() const {
    return *program_;
  }

private:
  // With whatever the initial values are where they depend on the host.
  struct Ready {
    std::unique_ptr<Interpreter> interpreter;
    bool suits_all = true; // they do not
  };

  // The lock is held only while an interpreter is taken or put back, never
  // while code runs.
  Ready take(Host& host) const;

  const std::shared_ptr<const Program> program_;
  mutable std::mutex mutex_;
  mutable std::vector<std::unique_ptr<Interpreter>> free_;
};

} // namespace parlour::script
