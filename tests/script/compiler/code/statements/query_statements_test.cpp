#include <gtest/gtest.h>

#include "script/compiler/code/statements/query_statements.hpp"
#include "tests/script/compiler/code/compiled_statements.hpp"

namespace parlour::script {

namespace {

TEST(QueryStatements, BindTheValuesOfTheirText) {
  EXPECT_EQ(test::finding("<var name='x' expr='1'/><querydb "
                          "param='select {x}' return='r'/>"),
            "");
  EXPECT_NE(test::finding(R"x(<querydb param="select ?" return="r"/>)x")
                .find("the statement has 1 placeholders"),
            std::string::npos);
}

} // namespace

} // namespace parlour::script
