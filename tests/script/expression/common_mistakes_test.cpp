#include <gtest/gtest.h>

#include "script/expression/common_mistakes.hpp"

namespace parlour::script {

TEST(Mistakes, are_found_whatever_the_case) {
  for (const auto* word : {"null", "NULL", "Null"}) {
    const auto* mistake = find_mistake(MistakePlace::operand, word);
    ASSERT_TRUE(mistake) << word;
    EXPECT_EQ(mistake->meant, "unknown");
  }
  EXPECT_FALSE(find_mistake(MistakePlace::operand, "visitor"));
}

TEST(Mistakes, are_not_what_is_right) {
  EXPECT_FALSE(find_mistake(MistakePlace::operand, "true"));
  EXPECT_TRUE(find_mistake(MistakePlace::operand, "True"));
}

TEST(Mistakes, mean_what_may_stand_there) {
  const std::vector<std::string> names{"cond"}, others{"param"};
  EXPECT_TRUE(find_mistake(MistakePlace::attribute, "condition", &names));
  EXPECT_FALSE(find_mistake(MistakePlace::attribute, "condition", &others));
  // A sentence without a word helps everywhere.
  EXPECT_TRUE(find_mistake(MistakePlace::element, "then", &others));
}

} // namespace parlour::script
