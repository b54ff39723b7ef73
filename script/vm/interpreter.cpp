// The public interface over Machine: it hides the machine's headers, computes
// initial values, and shortens code that only returns a constant.

#include "script/vm/interpreter.hpp"

#include "script/program/constant_text.hpp"
#include "script/values/convert.hpp"
#include "script/vm/interpreter_state.hpp"
#include "script/vm/known_values.hpp"
#include "script/vm/machine.hpp"

namespace parlour::script {

namespace {

const KnownValues& known_values(const std::shared_ptr<const Program>& program) {
  return known_values_of(*program, [&](CodeId code, Host& host) {
    return Interpreter(program).evaluate(code, {}, {}, host);
  });
}

} // namespace

// Hides the machine from users of the interpreter, who need none of its
// headers.
struct Interpreter::Implementation : Machine {
  using Machine::Machine;

  // Gives a variable the value that it has in all sessions, if it has one. What
  // needs memory is made when it is looked at.
  bool begins_as_known(std::size_t index) {
    const auto& known = known_values(program)[index];
    if (!known)
      return false;
    if (const auto* constant =
            constant_of(code[program->variables[index].initial]))
      variables[index] = *constant;
    else if (known->type() <= ValueType::number)
      variables[index] = to_box(heap(), *known);
    else
      variables[index] = Box::missing();
    return true;
  }
};

Interpreter::Interpreter(std::shared_ptr<const Program> program)
    : implementation_(std::make_unique<Implementation>(std::move(program))) {}

Interpreter::~Interpreter() = default;
Interpreter::Interpreter(Interpreter&&) noexcept = default;
Interpreter& Interpreter::operator=(Interpreter&&) noexcept = default;

Expected<void> Interpreter::initialise(Host& host) {
  for (std::size_t i = 0; i < program().variables.size(); ++i)
    if (auto ready = initialise(i, host); !ready)
      return ready;
  return {};
}

// Errors are ignored: the value stays unknown.
void Interpreter::initialise_what_computes(Host& host) {
  for (std::size_t i = 0; i < program().variables.size(); ++i)
    static_cast<void>(initialise(i, host));
}

// A variable without `expr` stays unknown.
Expected<void> Interpreter::initialise(std::size_t index, Host& host) {
  const auto code = program().variables[index].initial;
  if (code == no_code)
    return {};
  ++implementation_->writes;
  if (implementation_->begins_as_known(index))
    return {};
  auto value = evaluate(code, {}, {}, host);
  if (!value)
    return tl::make_unexpected(std::move(value.error()));
  set_variable(index, std::move(*value));
  return {};
}

std::unique_ptr<Activation>
Interpreter::start(CodeId code, const std::vector<Value>& arguments,
                   ActivationContext context) {
  return implementation_->start(code, arguments, std::move(context));
}

std::optional<StoppedBody>
Interpreter::run_body(CodeId code, const std::vector<Value>& arguments,
                      ActivationContext context, Host& host) {
  auto activation = implementation_->start(code, arguments, std::move(context));
  if (auto stopped = implementation_->run_body(*activation, host))
    return StoppedBody{std::move(*stopped), std::move(activation)};
  implementation_->keep_spare(std::move(activation));
  return std::nullopt;
}

RunResult Interpreter::run(Activation& activation, Host& host) {
  return implementation_->run(static_cast<Execution&>(activation), host, false);
}

RunResult Interpreter::resume(Activation& activation, Expected<Value> outcome,
                              Host& host) {
  return implementation_->resume(static_cast<Execution&>(activation), outcome,
                                 host);
}

Expected<Value> Interpreter::evaluate(CodeId code,
                                      const std::vector<Value>& arguments,
                                      ActivationContext context, Host& host) {
  // Constant texts, which are frequent, need no activation.
  if (const auto* constant = constant_of(program().code[code]))
    return to_value(*constant);
  auto activation = implementation_->start(code, arguments, std::move(context));
  auto result = implementation_->run(*activation, host, true);
  if (result.status == RunStatus::failed)
    return tl::make_unexpected(std::move(result.error));
  implementation_->keep_spare(std::move(activation));
  return std::move(result.value);
}

void Interpreter::new_event() {
  implementation_->new_event();
}

void Interpreter::limit_instructions(std::uint64_t instructions) {
  implementation_->instructions = instructions;
}

const Program& Interpreter::program() const {
  return *implementation_->program;
}

Value Interpreter::variable(std::size_t index) const {
  const auto& box = implementation_->variables[index];
  return box.is_missing() ? (*program().initial_values)[index] : to_value(box);
}

void Interpreter::set_variable(std::size_t index, Value value) {
  ++implementation_->writes;
  implementation_->variables[index] = to_box(implementation_->heap(), value);
}

std::uint64_t Interpreter::writes() const {
  return implementation_->writes;
}

std::string
Interpreter::save(const std::vector<const Activation*>& activations) const {
  std::vector<const Execution*> executions;
  for (const auto* activation : activations)
    executions.push_back(static_cast<const Execution*>(activation));
  return state_of(*implementation_, executions);
}

Expected<Restored> Interpreter::restore(std::shared_ptr<const Program> program,
                                        std::string_view bytes) {
  known_values(program); // which the state may refer to
  Restored restored{Interpreter(std::move(program)), {}};
  auto executions = restore_state(*restored.interpreter.implementation_, bytes);
  if (!executions)
    return tl::make_unexpected(std::move(executions.error()));
  for (auto& execution : *executions)
    restored.activations.push_back(std::move(execution));
  return restored;
}

std::size_t Interpreter::bytes_held() const {
  return implementation_->heap().used();
}

void Interpreter::set_slice(std::uint64_t instructions) {
  implementation_->slice = instructions;
}

} // namespace parlour::script
