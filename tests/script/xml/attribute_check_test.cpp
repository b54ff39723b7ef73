#include <gtest/gtest.h>

#include "script/xml/attribute_check.hpp"

namespace parlour::script {

namespace {

std::string judge(AttributeKind kind, const std::string& value) {
  ElementRule element;
  element.name = "e";
  AttributeRule rule;
  rule.name = "a";
  rule.kind = kind;
  rule.words = {"list", "map"};
  return wrong_value(element, rule, value);
}

} // namespace

TEST(AttributeCheck, says_what_was_expected) {
  EXPECT_EQ(judge(AttributeKind::boolean, "true"), "");
  EXPECT_EQ(judge(AttributeKind::boolean, "1"),
            "a=\"1\" of <e>: expected true or false");
  EXPECT_EQ(judge(AttributeKind::choice, "lisst"),
            "a=\"lisst\" of <e>: expected list or map, did you mean 'list'?");
  EXPECT_EQ(judge(AttributeKind::size, "16MB"), "");
  EXPECT_NE(judge(AttributeKind::size, "16 apples"), "");
}

TEST(AttributeCheck, leaves_to_the_run_what_is_known_then) {
  EXPECT_EQ(judge(AttributeKind::duration, "{seconds}s"), "");
  EXPECT_NE(judge(AttributeKind::duration, "seconds"), "");
  EXPECT_EQ(judge(AttributeKind::expression, "((("), "");
}

TEST(AttributeCheck, knows_identifiers) {
  EXPECT_TRUE(is_identifier("staffList"));
  EXPECT_TRUE(is_identifier("_1"));
  EXPECT_TRUE(is_identifier("größe"));
  EXPECT_FALSE(is_identifier("1a"));
  EXPECT_FALSE(is_identifier("a-b"));
  EXPECT_FALSE(is_identifier(""));
}

TEST(AttributeCheck, reads_sizes_and_counts) {
  EXPECT_EQ(parse_size("64KB"), 65536u);
  EXPECT_EQ(parse_size("1GB"), std::size_t{1} << 30);
  EXPECT_FALSE(parse_size("99999999999GB"));
  EXPECT_FALSE(parse_size("MB"));
  EXPECT_EQ(parse_count("0"), 0u);
  EXPECT_FALSE(parse_count("-1"));
  EXPECT_FALSE(parse_count("1.5"));
  EXPECT_FALSE(parse_count("99999999999999999999"));
}

} // namespace parlour::script
