#include "script/host.hpp"

namespace parlour::script {

const Value& Effect::operand(std::size_t index) const {
  static const Value unknown;
  return index < operands.size() ? operands[index] : unknown;
}

} // namespace parlour::script
