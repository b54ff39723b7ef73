#include <gtest/gtest.h>

#include "script/host.hpp"

namespace parlour::script {

namespace {

TEST(Effect, AMissingOperandIsUnknown) {
  Effect effect;
  effect.operands = {Value(1)};
  EXPECT_EQ(effect.operand(0), Value(1));
  EXPECT_TRUE(effect.operand(1).is_unknown());
}

} // namespace

} // namespace parlour::script
