// Branches and loops (language rule 6); <confirm>, which is both (language rule
// 12.20).
#include <utility>

#include "script/compiler/code/statements.hpp"

namespace parlour::script {

void StatementCompiler::reached(const Element& element) {
  b_.at(element.position);
  b_.emit(Operation::reached);
}

// Jumps that are taken where the condition does not hold.
std::vector<Label> StatementCompiler::condition(const Element& element,
                                                const char* attribute) {
  std::vector<Label> otherwise;
  const auto* condition = required(element, attribute);
  if (!condition)
    return otherwise;
  const auto source = source_of(*condition);
  if (const auto node = expressions_.parse(source))
    expressions_.jump(*node, source, false, otherwise);
  return otherwise;
}

// The constant that the test since `start` compares a local with, where it is
// no more than that.
std::optional<Box> StatementCompiler::compared(std::uint32_t start) {
  const auto* test = b_.only(start, Operation::jump_if_equal_constant);
  if (!test || test->flag)
    return {};
  return b_.code.constants[test->b];
}

// A table in front of the first test, which is moved behind it.
std::optional<TableBuilder>
StatementCompiler::enter_by_table(std::uint32_t& start,
                                  std::vector<Label>& otherwise) {
  if (!compared(start))
    return {};
  const auto test = b_.take_back();
  TableBuilder table(b_, test.a);
  start = b_.here();
  otherwise = {b_.emit(Operation::jump_if_equal_constant, test.a, test.b)};
  return table;
}

// A chain of conditions that compare one local with constants is entered by a
// table.
void StatementCompiler::if_(const Element& element) {
  std::vector<Label> done;
  auto start = b_.here();
  auto otherwise = condition(element, "cond");
  std::optional<TableBuilder> table;
  if (element.children.size() >= TableBuilder::fewest_tests)
    table = enter_by_table(start, otherwise);
  const auto value = table ? b_.code.instructions[start].a : 0;
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

// The test of a <case>: jumps where it is the value.
void StatementCompiler::test(Switch& arms, const Element& element) {
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

// All tests first, then the bodies; no fall-through.
void StatementCompiler::switch_(const Element& element) {
  const auto mark = b_.mark();
  Switch arms{b_.allocate(), {}, {}};
  if (const auto* subject = required(element, "expr"))
    expressions_.expression(source_of(*subject), arms.value);
  if (element.children.size() >= TableBuilder::fewest_tests)
    arms.table.emplace(b_, arms.value);
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
    const auto outer = std::exchange(in_case_, true);
    block(*arm.element);
    in_case_ = outer;
    done.push_back(b_.emit(Operation::jump));
  }
  b_.land(done);
  b_.release(mark);
}

void StatementCompiler::end_loop() {
  b_.land(loops_.back().breaks);
  loops_.pop_back();
}

void StatementCompiler::for_(const Element& element) {
  if (element.attribute("each"))
    return for_each(element);
  b_.open_scope();
  const auto base = b_.allocate(4); // machine_operations.cpp, for_prepare
  if (const auto* from = required(element, "from"))
    expressions_.expression(source_of(*from), static_cast<Register>(base + 1));
  b_.load(static_cast<Register>(base + 2), Box::small(1));
  if (const auto* step = element.attribute("step"))
    expressions_.expression(source_of(*step), static_cast<Register>(base + 2));
  if (const auto* to = required(element, "to"))
    expressions_.expression(source_of(*to), static_cast<Register>(base + 3));
  const auto* name = required(element, "name");
  b_.declare(name ? name->value : " ");
  b_.at(element.position);
  const auto none = b_.emit(Operation::for_prepare, base);
  const auto body = b_.here();
  loops_.push_back({{}, {}, transactions_.size()});
  block(element);
  b_.land(loops_.back().continues);
  b_.at(element.position);
  b_.back(Operation::for_next, base, body);
  b_.land(none);
  end_loop();
  b_.close_scope();
}

void StatementCompiler::for_each(const Element& element) {
  b_.open_scope();
  const auto base = b_.allocate(2); // what is walked over, and the position
  if (const auto* collection = required(element, "in"))
    expressions_.expression(source_of(*collection), base);
  b_.emit(Operation::each_prepare, base, base);
  const auto* index = element.attribute("index");
  b_.declare(element.attribute("each")->value);
  b_.declare(index ? index->value : " ");
  const auto next = b_.here();
  const auto done = b_.emit(Operation::each_next, base);
  loops_.push_back({{}, {}, transactions_.size()});
  block(element);
  b_.land(loops_.back().continues);
  b_.at(element.position);
  b_.back(Operation::loop, 0, next);
  b_.land(done);
  end_loop();
  b_.close_scope();
}

void StatementCompiler::while_(const Element& element) {
  const auto start = b_.here();
  const auto otherwise = condition(element, "cond");
  loops_.push_back({{}, {}, transactions_.size()});
  block(element);
  b_.land(loops_.back().continues);
  b_.at(element.position);
  b_.back(Operation::loop, 0, start);
  b_.land(otherwise);
  end_loop();
}

void StatementCompiler::break_(const Element& element) {
  if (loops_.empty())
    return error(element.position,
                 in_case_ ? "<break> stands outside of a loop; a <case> ends "
                            "by itself: leave it out"
                          : "<break> stands outside of a loop");
  end_transactions(loops_.back().transactions);
  loops_.back().breaks.push_back(b_.emit(Operation::jump));
}

void StatementCompiler::continue_(const Element& element) {
  if (loops_.empty())
    return error(element.position, "<continue> stands outside of a loop");
  end_transactions(loops_.back().transactions);
  loops_.back().continues.push_back(b_.emit(Operation::jump));
}

// Without an answer (unknown) the question is computed and asked anew.
void StatementCompiler::confirm(const Element& element) {
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

} // namespace parlour::script
