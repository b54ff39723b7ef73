#include <gtest/gtest.h>

#include "script/spoken/letter_case.hpp"

namespace parlour::script {

namespace {

TEST(LetterCase, IsThatOfAnyAlphabet) {
  EXPECT_EQ(capitals("straße é"), "STRASSE É");
  EXPECT_EQ(small_letters("ÄB ΣΑΣ"), "äb σας");
  EXPECT_EQ(capitals(""), "");
}

TEST(LetterCase, LeavesWhatIsNoLetter) {
  EXPECT_EQ(capitals("@az[`{ 09"), "@AZ[`{ 09");
  EXPECT_EQ(small_letters("@AZ[`{ 09"), "@az[`{ 09");
}

} // namespace

} // namespace parlour::script
