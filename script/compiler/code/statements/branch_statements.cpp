// Branches (language rule 6), and <confirm> (language rule 12.20), which is
// one.
#include "script/compiler/code/statements/branch_statements.hpp"

#include <utility>

namespace parlour::script {

// The constant with which the condition compiled since `start` compares a local
// variable; nothing if the condition is anything else.
std::optional<Box> BranchStatements::compared(std::uint32_t start) {
  const auto* test = b_.only(start, Operation::jump_if_equal_constant);
  if (!test || test->flag)
    return {};
  return b_.code.constants[test->b];
}

// Emits the jump by table in front of the first test of a chain, by removing
// that test and emitting it again behind the jump.
std::optional<TableBuilder>
BranchStatements::enter_by_table(std::uint32_t& start,
                                 std::vector<Label>& otherwise) {
  if (!compared(start))
    return {};
  const auto test = b_.take_back();
  TableBuilder table(b_, test.a);
  start = b_.here();
  otherwise = {b_.emit(Operation::jump_if_equal_constant, test.a, test.b)};
  return table;
}

// Compiles the parts of an <if> one after the other. In a long <if> whose
// conditions compare one local variable with constants, the chain is entered by
// a jump table (table_builder.hpp). The tests stay for values that the table
// does not know.
void BranchStatements::if_(const Element& element) {
  std::vector<Label> done;
  auto start = b_.here();
  auto otherwise = condition(element, "cond");
  std::optional<TableBuilder> table;
  if (element.children.size() >= TableBuilder::fewest_tests)
    table = enter_by_table(start, otherwise);
  const auto value = table ? b_.code.instructions[start].a : 0;
  // Adds the part that was just tested to the table, if its test compares the
  // same local variable with a constant.
  const auto arm = [&] {
    if (!table)
      return;
    auto constant = compared(start);
    if (constant && b_.code.instructions[start].a != value)
      constant.reset();
    if (table->takes(start, constant))
      table->arm(*constant, b_.here());
  };
  arm();
  reached(element);
  block(element, {"elseif", "else"});
  for (const auto& child : element.children) {
    const bool tests = child.is("elseif");
    if (!tests && !child.is("else"))
      continue;
    done.push_back(b_.emit(Operation::jump));
    b_.land(otherwise);
    b_.at(child.position);
    start = b_.here();
    otherwise = tests ? condition(child, "cond") : std::vector<Label>{};
    arm();
    reached(child);
    block(child);
  }
  if (table)
    table->end(b_.here());
  b_.land(otherwise);
  b_.land(done);
}

// Compiles the test of a <case>: a jump that is taken if the value is equal.
// The value is compiled first and looked at afterwards: a constant becomes an
// operand of the jump.
void BranchStatements::test(Switch& arms, const Element& element) {
  const auto* candidate = element.attribute("value");
  if (!candidate)
    return;
  b_.at(element.position);
  const auto start = b_.here();
  const auto operand = b_.allocate();
  expressions_.text_or_expression(source_of(*candidate), operand);
  b_.release(operand);
  Case arm{&element, 0, {}};
  if (b_.only(start, Operation::load_constant)) {
    const auto constant = b_.take_back().b;
    arm.constant = b_.code.constants[constant];
    arm.label = b_.emit(Operation::jump_if_equal_constant, arms.value, constant,
                        0, true);
  } else {
    arm.label = b_.emit(Operation::jump_if_equal, arms.value, operand, 0, true);
  }
  if (arms.table && !arms.table->takes(start, arm.constant))
    arm.constant.reset();
  arms.cases.push_back(std::move(arm));
}

// All tests come first and then all bodies, each of which ends with a jump
// behind the <switch>, so there is no fall-through (language rule 6.2). With
// enough cases the tests are preceded by a jump table.
//
//       value = expr
//       jump_by_table value         only with enough cases
//       jump_if_equal value, 1 -> one
//       jump_if_equal value, 2 -> two
//       …                           <default>
//       jump end
//   one:  …  jump end
//   two:  …  jump end
//   end:
void BranchStatements::switch_(const Element& element) {
  const auto mark = b_.mark();
  Switch arms{b_.allocate(), {}, {}};
  if (const auto* subject = required(element, "expr"))
    expressions_.expression(source_of(*subject), arms.value);
  if (element.children.size() >= TableBuilder::fewest_tests)
    arms.table.emplace(b_, arms.value);
  // <default> may stand anywhere; its body follows the tests directly, where a
  // value without an arm arrives.
  const Element* otherwise = nullptr;
  for (const auto& child : element.children) {
    if (child.is("default"))
      otherwise = &child;
    else if (child.is("case"))
      test(arms, child);
  }
  if (arms.table)
    arms.table->end(b_.here());
  std::vector<Label> done;
  if (otherwise) {
    reached(*otherwise);
    block(*otherwise);
  }
  done.push_back(b_.emit(Operation::jump));
  for (const auto& arm : arms.cases) {
    b_.land(arm.label);
    if (arms.table && arm.constant)
      arms.table->arm(*arm.constant, b_.here());
    reached(*arm.element);
    const auto outer = std::exchange(body_.in_case, true);
    block(*arm.element);
    body_.in_case = outer;
    done.push_back(b_.emit(Operation::jump));
  }
  b_.land(done);
  b_.release(mark);
}

// The answer is a boolean. Unknown means that the question must be asked anew,
// with values that may have changed, so the code loops back to computing it.
void BranchStatements::confirm(const Element& element) {
  const auto base = b_.allocate(2);
  const auto start = b_.here();
  operand(element, "question", OperandForm::either, base);
  operand(element, "slot", OperandForm::slot, static_cast<Register>(base + 1));
  b_.at(element.position);
  perform(EffectKind::confirm, base, base, 2);
  const auto answered = b_.emit(Operation::jump_if_equal_constant, base,
                                b_.constant(Box()), 0, false);
  b_.back(Operation::loop, 0, start);
  b_.land(answered);
  const auto refused = b_.emit(Operation::jump_if, base, 0, 0, false);
  b_.release(base);
  if (const auto* yes = element.child("yes")) {
    reached(*yes);
    block(*yes);
  }
  const auto done = b_.emit(Operation::jump);
  b_.land(refused);
  if (const auto* no = element.child("no")) {
    reached(*no);
    block(*no);
  }
  b_.land(done);
}

void BranchStatements::summary(const Element* refused, bool only_if_unsure) {
  const auto base = b_.allocate();
  const auto start = b_.here();
  b_.load(base, Box::boolean(only_if_unsure));
  perform(EffectKind::summarise, base, base, 1);
  const auto answered = b_.emit(Operation::jump_if_equal_constant, base,
                                b_.constant(Box()), 0, false);
  b_.back(Operation::loop, 0, start);
  b_.land(answered);
  const auto agreed = b_.emit(Operation::jump_if, base, 0, 0, true);
  if (refused)
    block(*refused);
  else
    perform(EffectKind::ask_change, base, base, 0);
  b_.emit(Operation::give_unknown);
  b_.land(agreed);
  b_.release(base);
}

} // namespace parlour::script
