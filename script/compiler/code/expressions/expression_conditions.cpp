// Conditions: comparison and jump in one instruction where possible. `and`,
// `or` and `not` need no instructions of their own: they only decide where the
// jumps of their operands go.
#include <array>

#include "script/compiler/code/expressions/expression_compiler.hpp"

namespace parlour::script {

void ExpressionCompiler::jump(const Node& node, const Source& source, bool when,
                              std::vector<Label>& labels) {
  const auto mark = b_.mark();
  if (node.kind == NodeKind::invert) {
    jump(*node.children[0], source, !when, labels);
  } else if (node.kind == NodeKind::both || node.kind == NodeKind::either) {
    // In `a or b` a true `a` decides, in `a and b` a false one. If the deciding
    // truth is the one to jump at, the first operand jumps to the target;
    // otherwise it jumps past the second operand.
    const bool decides = node.kind == NodeKind::either;
    std::vector<Label> past;
    jump(*node.children[0], source, decides, decides == when ? labels : past);
    jump(*node.children[1], source, when, labels);
    b_.land(past);
  } else if (node.kind == NodeKind::binary && node.operation < Operator::in) {
    compare_jump(node, source, when, labels);
  } else {
    const auto value = any(node, source);
    labels.push_back(b_.emit(Operation::jump_if, value, 0, 0, when));
  }
  b_.release(mark);
}

// Emits a comparison that jumps. The flag says for which outcome the jump is
// taken; != is == with the flag reversed. For > and >= there are instructions
// with a constant only; with two registers the operands are exchanged.
void ExpressionCompiler::compare_jump(const Node& node, const Source& source,
                                      bool when, std::vector<Label>& labels) {
  constexpr std::array<Operation, 6> with_constant{
      Operation::jump_if_equal_constant,
      Operation::jump_if_equal_constant,
      Operation::jump_if_less_constant,
      Operation::jump_if_less_equal_constant,
      Operation::jump_if_greater_constant,
      Operation::jump_if_greater_equal_constant};
  constexpr std::array<Operation, 6> with_register{
      Operation::jump_if_equal, Operation::jump_if_equal,
      Operation::jump_if_less,  Operation::jump_if_less_equal,
      Operation::jump_if_less,  Operation::jump_if_less_equal};
  const auto operation = static_cast<std::size_t>(node.operation);
  const bool flag = when != (node.operation == Operator::unequal);
  const auto left = any(*node.children[0], source);
  Box box;
  if (constant_of(*node.children[1], box)) {
    labels.push_back(
        b_.emit(with_constant[operation], left, b_.constant(box), 0, flag));
    return;
  }
  const auto right = any(*node.children[1], source);
  const bool swapped = node.operation >= Operator::greater;
  labels.push_back(b_.emit(with_register[operation], swapped ? right : left,
                           swapped ? left : right, 0, flag));
}

} // namespace parlour::script
