// querying-text: code that may only compute calls a function with effects. It
// would fail when it runs; a phrase would silently be skipped.
//
//   <function name="staff"><querydb … return="r"/>…</function>
//   <phrase act="greet">Ask {staff()}.</phrase>       never spoken
#include "script/lint/passes.hpp"
#include "script/program/effect_names.hpp"
#include "script/program/effect_search.hpp"

namespace parlour::script::lint {

namespace {

bool any_effect(EffectKind) {
  return true;
}

// Goes over every kind of code that runs under a ComputingHost.
class ComputingLint {
public:
  ComputingLint(const Program& program, Findings& findings)
      : program_(program), findings_(findings) {}

  void run();

private:
  void check(CodeId code, Position position, const std::string& what);
  void check(const std::vector<CodeId>& codes, Position position,
             const std::string& what);
  void check(const Topic& topic);
  void check(const Topic& topic, const Slot& slot);
  void check(const Variable& variable);

  const Program& program_;
  Findings& findings_;
};

void ComputingLint::check(CodeId code, Position position,
                          const std::string& what) {
  if (const auto effect = find_effect(program_, code, any_effect))
    warn(findings_, "querying-text", position,
         what + " can only compute, and calls a function with <" +
             element_of(effect->kind) +
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

// Variables are initialised before the session begins, so nothing can wait
// there.
void ComputingLint::check(const Variable& variable) {
  const auto found = find_effect(program_, variable.initial, waits);
  if (found && found->is_called)
    warn(findings_, "querying-text", found->call,
         "the expr of the variable '" + variable.name +
             "' cannot wait, and calls a function with <" +
             element_of(found->kind) +
             ">: no session can begin; <set> the variable when it has begun, "
             "in <Session><Started>");
}

void ComputingLint::run() {
  for (const auto& variable : program_.variables)
    check(variable);
  for (const auto& phrase : program_.phrases) {
    check(phrase.condition, phrase.position, "the condition of a <phrase>");
    check(phrase.text, phrase.position, "a <phrase>");
  }
  for (const auto& topic : program_.topics)
    check(topic);
  for (const auto& repair : program_.repairs)
    check(repair.condition, repair.position, "the condition of a <repair>");
  for (const auto& route : program_.routes) {
    check(route.condition, route.position, "the condition of a route");
    check(route.params, route.position, "a parameter of a route");
  }
  for (const auto& opening : program_.openings)
    check(opening.condition, opening.position, "the condition of an <open>");
}

} // namespace

void lint_computing(const LintContext& context, Findings& findings) {
  ComputingLint(context.program, findings).run();
}

} // namespace parlour::script::lint
