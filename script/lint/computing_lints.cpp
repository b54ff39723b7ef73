// querying-text: what may only compute, and calls a function that wants
// something from outside: such a phrase is dropped when it would be said.
#include <map>
#include <optional>

#include "script/code.hpp"
#include "script/effect_names.hpp"
#include "script/instruction.hpp"
#include "script/lint/passes.hpp"

namespace parlour::script::lint {

namespace {

// A name that is computed may be anything.
CodeId called_by(const Instruction& instruction) {
  const auto operation = static_cast<Operation>(instruction.operation);
  return operation == Operation::call ? instruction.wide() : no_code;
}

class ComputingLint {
public:
  ComputingLint(const Program& program, Findings& findings)
      : program_(program), findings_(findings) {}

  void run();

private:
  // The first effect that the code has or calls; nothing where it computes.
  std::optional<EffectKind> effect_of(CodeId code);
  std::optional<EffectKind> effect_in(const Code& code);

  void check(CodeId code, Position position, const std::string& what);
  void check(const std::vector<CodeId>& codes, Position position,
             const std::string& what);
  void check(const Topic& topic);
  void check(const Topic& topic, const Slot& slot);

  const Program& program_;
  Findings& findings_;
  std::map<CodeId, std::optional<EffectKind>> known_;
};

std::optional<EffectKind> ComputingLint::effect_in(const Code& code) {
  for (const auto& instruction : code.instructions) {
    if (static_cast<Operation>(instruction.operation) == Operation::effect)
      return static_cast<EffectKind>(code.effects[instruction.c].kind);
    if (const auto called = called_by(instruction); called != no_code)
      if (auto effect = effect_of(called))
        return effect;
  }
  return {};
}

std::optional<EffectKind> ComputingLint::effect_of(CodeId code) {
  if (code >= program_.code.size())
    return {};
  const auto [known, fresh] = known_.try_emplace(code); // a ring ends here
  if (fresh)
    known->second = effect_in(program_.code[code]);
  return known->second;
}

void ComputingLint::check(CodeId code, Position position,
                          const std::string& what) {
  if (const auto effect = effect_of(code))
    warn(findings_, "querying-text", position,
         what + " can only compute, and calls a function with <" +
             element_of(*effect) +
             ">: it fails when it is wanted; compute the value before, in "
             "<filled> or <completed>");
}

void ComputingLint::check(const std::vector<CodeId>& codes, Position position,
                          const std::string& what) {
  for (const auto code : codes)
    check(code, position, what);
}

void ComputingLint::check(const Topic& topic, const Slot& slot) {
  const auto of_slot = " of the slot '" + topic.name + "." + slot.name + "'";
  check(slot.initial, slot.position, "the expr" + of_slot);
  check(slot.question, slot.position, "the question" + of_slot);
  check(slot.help, slot.position, "<help>" + of_slot);
  check(slot.explain, slot.position, "<explain>" + of_slot);
  check(slot.cardinality.values, slot.position, "a <value>" + of_slot);
  check(slot.cardinality.minimum, slot.position, "the range" + of_slot);
  check(slot.cardinality.maximum, slot.position, "the range" + of_slot);
}

void ComputingLint::check(const Topic& topic) {
  for (const auto& slot : topic.slots)
    check(topic, slot);
  for (const auto& constraint : topic.constraints) {
    check(constraint.condition, constraint.position, "a constraint");
    check(constraint.message, constraint.position, "a constraint's message");
  }
  for (const auto& rule : topic.rules)
    check(rule.condition, rule.position, "the condition of a <rule>");
}

void ComputingLint::run() {
  for (const auto& phrase : program_.phrases) {
    check(phrase.condition, phrase.position, "the condition of a <phrase>");
    check(phrase.text, phrase.position, "a <phrase>");
  }
  for (const auto& topic : program_.topics)
    check(topic);
  for (const auto& repair : program_.repairs)
    check(repair.condition, repair.position, "the condition of a <repair>");
}

} // namespace

void lint_computing(const Subject& subject, Findings& findings) {
  ComputingLint(subject.program, findings).run();
}

} // namespace parlour::script::lint
