#include <gtest/gtest.h>

#include "script/compiler/code/statements/variable_statements.hpp"
#include "tests/script/compiler/code/compiled_statements.hpp"

namespace parlour::script {

namespace {

TEST(VariableStatements, DeclareSetAndAppend) {
  EXPECT_EQ(
      test::printed(
          R"x(<var name="l" expr="[1]"/><append name="l" expr="2"/><set name="l[0]" expr="3"/><print param="{l}"/>)x"),
      "[3, 2]\n");
  EXPECT_NE(
      test::finding(R"x(<const name="c" expr="1"/><var name="c" expr="2"/>)x")
          .find("'c' is a constant"),
      std::string::npos);
}

} // namespace

} // namespace parlour::script
