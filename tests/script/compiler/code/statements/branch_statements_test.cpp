#include <gtest/gtest.h>

#include "script/compiler/code/statements/branch_statements.hpp"
#include "tests/script/compiler/code/compiled_statements.hpp"

namespace parlour::script {

namespace {

TEST(BranchStatements, ChooseOnePart) {
  EXPECT_EQ(
      test::printed(
          R"x(<var name="x" expr="2"/><if cond="x gt 2"><print param="a"/><else><print param="b"/></else></if><switch expr="x"><case value="2"><print param="two"/></case><default><print param="other"/></default></switch>)x"),
      "b\ntwo\n");
}

} // namespace

} // namespace parlour::script
