#include <gtest/gtest.h>

#include "script/dialogue/frame/spelling.hpp"

namespace parlour::dialogue {

namespace {

TEST(Spelling, FoldsCasePunctuationAndBlanks) {
  EXPECT_EQ(folded("  Dr. Jeffery   HO! "), "dr jeffery ho");
  EXPECT_EQ(folded("ÉCOLE"), "école");
  EXPECT_EQ(folded("Jeffery's"), "jefferys");
  EXPECT_EQ(folded("..."), "");
  EXPECT_EQ(folded("\xff\xfe"), folded("\xff\xfe")); // no crash
}

struct Case {
  const char* said;
  const char* canonical;
  int distance; // -1: too far
};

class SpellingDistance : public testing::TestWithParam<Case> {};

TEST_P(SpellingDistance, Is) {
  EXPECT_EQ(
      spelling_distance(GetParam().said, GetParam().canonical).value_or(-1),
      GetParam().distance);
}

INSTANTIATE_TEST_SUITE_P(
    All, SpellingDistance,
    testing::Values(
        Case{"sky GARDEN", "Sky garden", 0},
        Case{"garden sky", "Sky garden", 1},
        Case{"Sky gardens", "Sky garden", 1},
        Case{"coffee shops", "Coffee shop", 1}, Case{"galleries", "Gallery", 1},
        Case{"sky gardne", "Sky garden", 3},
        Case{"swiming pool", "Swimming pool", 3},
        Case{"pool swiming", "Swimming pool", 3},
        Case{"foodcourt", "Food court", 2}, Case{"auditoriun", "Auditorium", 3},
        Case{"Room 2", "Room 1", -1}, Case{"lift b", "Lift A", -1},
        Case{"cat", "car", -1}, Case{"swimming", "Swimming pool", -1},
        Case{"bakery", "Auditorium", -1}, Case{"", "Auditorium", -1},
        Case{"...", "Auditorium", -1}, Case{"", "", 0}));

TEST(Spelling, FindsPartsOfAName) {
  EXPECT_TRUE(has_words("Tan Bee Hoon", "hoon, bee"));
  EXPECT_FALSE(has_words("Tan Bee Hoon", "Ah Kow"));
  EXPECT_FALSE(has_words("Tan Bee Hoon", ""));
}

} // namespace

} // namespace parlour::dialogue
