#include <set>

#include <gmock/gmock.h>

#include "script/schema/schema_names.hpp"

namespace parlour::script {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(SchemaNames, are_different) {
  std::set<std::string> names;
  for (const auto& rule : element_table())
    EXPECT_TRUE(names.insert(schema_name(rule)).second);
}

TEST(SchemaNames, are_spelt_in_two_ways) {
  EXPECT_THAT(spellings("speak"), ElementsAre("speak", "Speak"));
  EXPECT_THAT(spellings("Entrance"), ElementsAre("Entrance", "entrance"));
}

TEST(SchemaNames, know_words_and_patterns) {
  AttributeRule rule;
  rule.kind = AttributeKind::boolean;
  EXPECT_THAT(words_of(rule), ElementsAre("true", "false"));
  rule.kind = AttributeKind::choice;
  rule.words = {"a", "b"};
  EXPECT_THAT(words_of(rule), ElementsAre("a", "b"));
  rule.kind = AttributeKind::expression;
  EXPECT_THAT(words_of(rule), IsEmpty());
  EXPECT_EQ(pattern_of(AttributeKind::expression), "");
  EXPECT_NE(pattern_of(AttributeKind::duration), "");
}

TEST(SchemaNames, find_the_rows_of_a_place) {
  EXPECT_TRUE(rows_within({}).empty());
  const auto rows = rows_within({"root"});
  ASSERT_FALSE(rows.empty());
  EXPECT_EQ(rows.front()->name, "settings");
}

} // namespace parlour::script
