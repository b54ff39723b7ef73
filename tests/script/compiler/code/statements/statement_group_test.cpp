#include <gtest/gtest.h>

#include "script/compiler/code/statements/statement_group.hpp"
#include "tests/script/compiler/code/compiled_statements.hpp"

namespace parlour::script {

namespace {

TEST(StatementGroup, AResultDeclaresItsVariableIfThereIsNone) {
  EXPECT_EQ(
      test::printed(
          R"x(<var name="u" expr="1"/><call function="upper" return="u"><var expr="'a'"/></call><call function="upper" return="v"><var expr="'b'"/></call><print param="{u}{v}"/>)x"),
      "AB\n");
  EXPECT_NE(
      test::finding(
          R"x(<call function="upper" return="1"><var expr="'a'"/></call>)x")
          .find("is not a variable"),
      std::string::npos);
}

} // namespace

} // namespace parlour::script
