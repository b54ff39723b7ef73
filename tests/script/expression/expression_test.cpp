#include <gtest/gtest.h>

#include "script/expression/expression.hpp"

namespace parlour::script {

namespace {

TEST(Expression, AnErrorSaysWhere) {
  const auto parsed = parse_expression("1 + (2 * ");
  EXPECT_FALSE(parsed.node);
  EXPECT_EQ(parsed.error_offset, 9u);
}

TEST(Expression, BindsLooserOperatorsLast) {
  const auto parsed = parse_expression("a or b and not c == 1 + 2 * -d[0].e");
  ASSERT_TRUE(parsed.node);
  EXPECT_EQ(parsed.node->kind, NodeKind::either);
  EXPECT_EQ(parsed.node->children[1]->kind, NodeKind::both);
  EXPECT_EQ(parsed.node->children[1]->children[1]->kind, NodeKind::invert);
}

TEST(Expression, IsBoundedInDepthAndLength) {
  std::string deep(100'000, '(');
  EXPECT_FALSE(parse_expression(deep).node);
  EXPECT_FALSE(parse_expression(std::string(100'000, '-') + "1").node);
  std::string row = "1";
  for (int i = 0; i < 100'000; ++i)
    row += "+1";
  EXPECT_FALSE(parse_expression(row).node);
}

TEST(Expression, ArgumentsAreAList) {
  const auto parsed = parse_arguments("this.A, 3");
  ASSERT_TRUE(parsed.node);
  EXPECT_EQ(parsed.node->children.size(), 2u);
  EXPECT_TRUE(parse_arguments("").node);
  EXPECT_FALSE(parse_arguments("1 2").node);
}

} // namespace

} // namespace parlour::script
