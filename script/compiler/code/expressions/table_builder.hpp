// TableBuilder: builds the jump table in front of a series of tests of one
// value against constants. The table covers the tests from the first on, as
// long as their constants are all strings or all integers. The tests themselves
// stay in the code, for values that the table knows nothing of: '5' equals 5,
// and a variable may hold anything.
//
// The order of use: the constructor emits the jump; takes() is called for each
// test in turn; arm() when the code of a taken test begins; end() behind the
// last test.
#pragma once

#include <optional>

#include "script/compiler/code/expressions/code_builder.hpp"

namespace parlour::script {

class TableBuilder {
public:
  // With fewer tests a table is no faster.
  static constexpr std::size_t fewest_tests = 4;

  // Emits the jump by table; the first test must follow.
  TableBuilder(CodeBuilder& builder, Register value);

  // Announces the next test, which begins at `start`. Returns false if the
  // table cannot cover it; the table then ends before it.
  bool takes(std::uint32_t start, const std::optional<Box>& constant);
  // Sets where the arm of a constant begins.
  void arm(const Box& constant, std::uint32_t target);
  // Sets where a value continues that is equal to none of the constants.
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
