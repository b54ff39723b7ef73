// The jump by table is emitted before its table is complete; arms are added
// when their code begins.

#include "script/compiler/code/expressions/table_builder.hpp"

namespace parlour::script {

TableBuilder::TableBuilder(CodeBuilder& builder, Register value)
    : b_(&builder), index_(builder.code.tables.size()) {
  b_->code.tables.emplace_back();
  b_->emit(Operation::jump_by_table, value, index_);
}

bool TableBuilder::takes(std::uint32_t start,
                         const std::optional<Box>& constant) {
  if (open_ && constant && JumpTable::may_hold(*constant) &&
      (!first_ || first_->is_string() == constant->is_string())) {
    first_ = constant;
    return true;
  }
  end(start);
  return false;
}

void TableBuilder::arm(const Box& constant, std::uint32_t target) {
  table().add(constant, target);
}

void TableBuilder::end(std::uint32_t target) {
  if (open_)
    table().otherwise(target);
  open_ = false;
}

} // namespace parlour::script
