#include "script/run/interpreter_pool.hpp"

#include <utility>

namespace parlour::script {

InterpreterPool::InterpreterPool(std::shared_ptr<const Program> program)
    : program_(std::move(program)) {}

// The interpreter returns to the pool also after an error.
Expected<Value> InterpreterPool::evaluate(CodeId code,
                                          const std::vector<Value>& arguments,
                                          ActivationContext context,
                                          Host& host) const {
  auto interpreter = take(host);
  interpreter->new_event();
  auto value = interpreter->evaluate(code, arguments, std::move(context), host);
  const std::lock_guard lock(mutex_);
  free_.push_back(std::move(interpreter));
  return value;
}

std::unique_ptr<Interpreter> InterpreterPool::take(Host& host) const {
  {
    const std::lock_guard lock(mutex_);
    if (!free_.empty()) {
      auto interpreter = std::move(free_.back());
      free_.pop_back();
      return interpreter;
    }
  }
  auto interpreter = std::make_unique<Interpreter>(program_);
  interpreter->initialise_what_computes(host);
  return interpreter;
}

} // namespace parlour::script
