#include <gtest/gtest.h>

#include "script/compiler/code/statements/error_statements.hpp"
#include "tests/script/compiler/code/compiled_statements.hpp"

namespace parlour::script {

namespace {

TEST(ErrorStatements, CatchWhatIsThrown) {
  EXPECT_EQ(
      test::printed(
          R"x(<try><throw expr="5"/><catch name="e"><print param="{e.kind} {e.value}"/></catch></try>)x"),
      "Thrown 5\n");
  EXPECT_NE(test::finding(R"x(<try><print param="a"/></try>)x")
                .find("<try> needs a <catch>"),
            std::string::npos);
}

} // namespace

} // namespace parlour::script
