#include "script/vm/known_values.hpp"

#include <algorithm>
#include <utility>

#include "script/program/computing_host.hpp"
#include "script/program/instruction.hpp"

namespace parlour::script {

namespace {

// Notices when it is asked for something that differs from session to session.
class SealedHost : public ComputingHost {
public:
  SealedHost() : ComputingHost("an initial value", 0) {}

  Performed perform(Activation& activation, const Effect& effect) override {
    was_asked_ = true;
    return ComputingHost::perform(activation, effect);
  }
  Timestamp now() const override {
    was_asked_ = true;
    return ComputingHost::now();
  }
  double random() override {
    was_asked_ = true;
    return ComputingHost::random();
  }
  bool online(const std::string& agent) const override {
    was_asked_ = true;
    return ComputingHost::online(agent);
  }
  bool was_asked() const {
    return was_asked_;
  }

private:
  mutable bool was_asked_ = false;
};

// Whether an instruction depends on what a session has, or leaves the code that
// is looked at, or must be seen by the session's host.
bool needs_session(const Instruction& instruction) {
  switch (static_cast<Operation>(instruction.operation)) {
  case Operation::bind_variable:
  case Operation::load_variable:
  case Operation::store_variable:
  case Operation::load_slot:
  case Operation::store_slot:
  case Operation::load_system:
  case Operation::load_message_parameter:
  case Operation::load_message_parameters:
  case Operation::call:
  case Operation::call_named:
  case Operation::effect:
  case Operation::reached:
    return true;
  default:
    return false;
  }
}

std::optional<Value> known_value(const Program& program, CodeId code,
                                 const Evaluate& evaluate) {
  if (code == no_code ||
      std::ranges::any_of(program.code[code].instructions, needs_session))
    return std::nullopt;
  SealedHost host;
  auto value = evaluate(code, host);
  if (!value || host.was_asked())
    return std::nullopt;
  return std::move(*value);
}

} // namespace

const KnownValues& known_values_of(const Program& program,
                                   const Evaluate& evaluate) {
  return program.initial_values->get([&] {
    KnownValues known;
    for (const auto& variable : program.variables)
      known.push_back(known_value(program, variable.initial, evaluate));
    return known;
  });
}

} // namespace parlour::script
