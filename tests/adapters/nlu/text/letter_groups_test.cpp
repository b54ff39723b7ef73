#include <gtest/gtest.h>

#include "adapters/nlu/text/letter_groups.hpp"

namespace parlour::adapters::nlu {
namespace {

constexpr LetterGroups groups(
    std::to_array<LetterGroup>({{"sch", "x"}, {"ch", "c"}, {"sc", "s"}}));

TEST(LetterGroups, find_the_first_with_which_a_text_begins) {
  const auto* found = groups.find("schema");
  ASSERT_NE(found, nullptr);
  EXPECT_EQ(found->sounds, "x");
  found = groups.find("scene");
  ASSERT_NE(found, nullptr);
  EXPECT_EQ(found->sounds, "s");
}

TEST(LetterGroups, find_nothing_within_a_text_or_in_other_signs) {
  EXPECT_EQ(groups.find("each"), nullptr);
  EXPECT_EQ(groups.find("c"), nullptr);
  EXPECT_EQ(groups.find(""), nullptr);
  EXPECT_EQ(groups.find("7"), nullptr);
  EXPECT_EQ(groups.find("\xC3\xA9"), nullptr);
}

TEST(LetterSet, has_its_letters_only) {
  constexpr LetterSet vowels("aeiou");
  EXPECT_TRUE(vowels.contains('a'));
  EXPECT_TRUE(vowels.contains('u'));
  EXPECT_FALSE(vowels.contains('b'));
  EXPECT_FALSE(vowels.contains('\0'));
  EXPECT_FALSE(vowels.contains('A'));
}

} // namespace
} // namespace parlour::adapters::nlu
