// TableBuilder: the table in front of a row of tests of one value against
// constants, while they are compiled. It holds the tests from the first on, as
// long as their constants are of one type; the tests themselves stay, for the
// values that it knows nothing of.
#pragma once

#include <optional>

#include "script/compiler/code/code_builder.hpp"

namespace parlour::script {

class TableBuilder {
public:
  // Fewer tests are as quick without.
  static constexpr std::size_t fewest_tests = 4;

  // Emits the jump; the first test follows.
  TableBuilder(CodeBuilder& builder, Register value);

  // The next test begins at `start`. False where the table ends before it.
  bool takes(std::uint32_t start, const std::optional<Box>& constant);
  // Where the arm of a constant that was taken begins.
  void arm(const Box& constant, std::uint32_t target);
  // Where a value that passes every test goes on.
  void end(std::uint32_t target);

private:
  JumpTable& table() {
    return b_->code.tables[index_];
  }

  CodeBuilder* b_;
  std::size_t index_;
  std::optional<Box> first_;
  bool open_ = true;
};

} // namespace parlour::script
