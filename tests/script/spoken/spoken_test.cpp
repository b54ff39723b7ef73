#include <gtest/gtest.h>

#include "script/spoken/spoken.hpp"

namespace parlour::script {

namespace {

TEST(Spoken, KnowsItsKinds) {
  for (const auto& kind : spoken_kinds())
    EXPECT_TRUE(is_spoken_kind(kind)) << kind;
  EXPECT_FALSE(is_spoken_kind("numeral"));
}

TEST(Spoken, SaysATelephoneNumberDigitByDigit) {
  EXPECT_EQ(spoken({"999", decimal_of(999.0), 0}, "phone"), "nine nine nine");
  EXPECT_EQ(spoken({"12", decimal_of(12.0), 0}, "phone"), "12");
  EXPECT_EQ(spoken({"12", decimal_of(12.0), 0}, "digits"), "one two");
}

// A slot may be given anything, and it must be said nevertheless.
TEST(Spoken, SaysWhatHasNoSuchFormAsItIs) {
  for (const auto& kind : spoken_kinds())
    EXPECT_EQ(spoken({"that", {}, 0}, kind), "that") << kind;
  EXPECT_EQ(spoken({"2.5", decimal_of(2.5), 0}, "numeral"), "2.5");
}

TEST(Spoken, SaysNumbersThatHaveNoSuchFormAsNumbers) {
  for (const auto* kind : {"ordinal", "year", "level"})
    EXPECT_EQ(spoken({"2.5", decimal_of(2.5), 0}, kind), "two point five");
}

} // namespace

} // namespace parlour::script
