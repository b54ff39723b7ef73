#include <gtest/gtest.h>

#include "script/expression/slips.hpp"

namespace parlour::script {

TEST(Slips, are_found_whatever_the_case) {
  for (const auto* word : {"null", "NULL", "Null"}) {
    const auto* slip = find_slip(SlipPlace::operand, word);
    ASSERT_TRUE(slip) << word;
    EXPECT_EQ(slip->meant, "unknown");
  }
  EXPECT_FALSE(find_slip(SlipPlace::operand, "visitor"));
}

TEST(Slips, are_not_what_is_right) {
  EXPECT_FALSE(find_slip(SlipPlace::operand, "true"));
  EXPECT_TRUE(find_slip(SlipPlace::operand, "True"));
}

TEST(Slips, mean_what_may_stand_there) {
  const std::vector<std::string> names{"cond"}, others{"param"};
  EXPECT_TRUE(find_slip(SlipPlace::attribute, "condition", &names));
  EXPECT_FALSE(find_slip(SlipPlace::attribute, "condition", &others));
  // A sentence without a word helps everywhere.
  EXPECT_TRUE(find_slip(SlipPlace::element, "then", &others));
}

} // namespace parlour::script
