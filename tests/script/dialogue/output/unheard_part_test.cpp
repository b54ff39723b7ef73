#include <gtest/gtest.h>

#include "script/dialogue/output/unheard_part.hpp"

namespace parlour::dialogue {
namespace {

constexpr const char* text =
    "The food court is on level 1 - it is open until 9:30pm, every day.";

TEST(UnheardPartTest, GoesOnAfterTheLastWord) {
  EXPECT_EQ(unheard_part(text, "The food court"),
            "is on level 1 - it is open until 9:30pm, every day.");
  EXPECT_EQ(unheard_part(text, "the FOOD court, is on level 1"),
            "- it is open until 9:30pm, every day.");
  EXPECT_EQ(unheard_part(text, "The food court is on level 1 it is open until "
                               "9:30pm"),
            "every day.");
}

TEST(UnheardPartTest, NothingIsLeftWhereAllWasHeard) {
  EXPECT_EQ(unheard_part(text, text), "");
  EXPECT_EQ(unheard_part("One two three -", "one two three"), "");
}

TEST(UnheardPartTest, LongDashesAndCurledMarksAreNoLetters) {
  EXPECT_EQ(
      unheard_part("It’s on level one — behind the lift.", "it's on level one"),
      "— behind the lift.");
  EXPECT_EQ(unheard_part("One two three …", "one two three"), "");
}

TEST(UnheardPartTest, AFewWordsAreSaidAgain) {
  EXPECT_EQ(unheard_part(text, ""), text);
  EXPECT_EQ(unheard_part(text, "The food"), text);
}

TEST(UnheardPartTest, WhatIsNotInTheTextIsNotSkipped) {
  EXPECT_EQ(unheard_part(text, "The food hall is"), text);
  EXPECT_EQ(unheard_part("One two three", "one two three four"),
            "One two three");
}

TEST(UnheardPartTest, KnowsLettersBesidesEnglishOnes) {
  EXPECT_EQ(unheard_part("Das Café öffnet um neun.", "Das Café öffnet"),
            "um neun.");
}

} // namespace
} // namespace parlour::dialogue
