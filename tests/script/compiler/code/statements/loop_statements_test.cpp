#include <gtest/gtest.h>

#include "script/compiler/code/statements/loop_statements.hpp"
#include "tests/script/compiler/code/compiled_statements.hpp"

namespace parlour::script {

namespace {

TEST(LoopStatements, GoRoundUntilTheyAreLeft) {
  EXPECT_EQ(
      test::printed(
          R"x(<for name="i" from="1" to="9"><if cond="i == 2"><continue/></if><if cond="i gt 3"><break/></if><print param="{i}"/></for>)x"),
      "1\n3\n");
  EXPECT_NE(
      test::finding(R"x(<break/>)x").find("<break> stands outside of a loop"),
      std::string::npos);
}

} // namespace

} // namespace parlour::script
