#include <gtest/gtest.h>

#include "script/expression/plain_brace.hpp"

namespace parlour::script {

namespace {

constexpr auto npos = std::string_view::npos;

TEST(PlainBrace, IsTheFirstThatEmbedsNothing) {
  EXPECT_EQ(plain_brace("{1 + 1} {{name}} end"), npos);
  EXPECT_EQ(plain_brace("a { so on }"), 2u);
  EXPECT_EQ(plain_brace("{a} }"), 4u);
  EXPECT_EQ(plain_brace(""), npos);
}

TEST(PlainBrace, AnEmbeddedExpressionMayHoldBracesItself) {
  const std::string_view text = "x {{'a': '}'}.a} y";
  EXPECT_TRUE(is_doubled(text, 2));
  const auto map = embedded("{ {'a': '}'}.a} y", 0);
  ASSERT_TRUE(map.node);
  EXPECT_EQ(map.end, 15u);
  EXPECT_FALSE(embedded("{ so on }", 0).node);
  EXPECT_FALSE(embedded("}", 0).node);
}

} // namespace

} // namespace parlour::script
