#include <gtest/gtest.h>

#include "script/compiler/code/statements/call_statements.hpp"
#include "tests/script/compiler/code/compiled_statements.hpp"

namespace parlour::script {

namespace {

TEST(CallStatements, CheckTheNumberOfArguments) {
  EXPECT_EQ(
      test::printed(
          R"x(<call function="upper" return="u"><var expr="'a'"/></call><print param="{u}"/>)x"),
      "A\n");
  EXPECT_NE(test::finding(R"x(<call function="upper"/>)x")
                .find("takes 1 argument, not 0"),
            std::string::npos);
}

} // namespace

} // namespace parlour::script
