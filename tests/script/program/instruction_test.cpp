#include <gtest/gtest.h>

#include "script/program/code.hpp"
#include "script/program/instruction.hpp"

namespace parlour::script {

namespace {

TEST(Instruction, HasANameForListings) {
  EXPECT_STREQ(name_of(Operation::jump_if_less_constant),
               "jump_if_less_constant");
  EXPECT_STREQ(name_of(Operation::reached), "reached");
}

TEST(Instruction, IsEightBytesAndHoldsAWideOperand) {
  static_assert(sizeof(Instruction) == 8);
  Instruction instruction;
  instruction.set_wide(0xfffffff0);
  EXPECT_EQ(instruction.wide(), 0xfffffff0u);
  EXPECT_EQ(instruction.distance(), -16);
}

} // namespace

} // namespace parlour::script
