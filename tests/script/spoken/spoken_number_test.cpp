#include <gtest/gtest.h>

#include "script/spoken/spoken_number.hpp"

namespace parlour::script {

namespace {

TEST(SpokenNumber, EndsWhereNobodyWouldListen) {
  EXPECT_EQ(cardinal_words(999'999'999'999'999),
            "nine hundred and ninety nine trillion nine hundred and ninety "
            "nine billion nine hundred and ninety nine million nine hundred "
            "and ninety nine thousand nine hundred and ninety nine");
  EXPECT_EQ(cardinal_words(1'000'000'000'000'000), "1000000000000000");
  EXPECT_EQ(cardinal_words(decimal_of(0.000001)),
            "zero point zero zero zero zero zero one");
  EXPECT_EQ(cardinal_words(decimal_of(0.0000001)), "1e-7");
}

TEST(SpokenNumber, LeavesOutWhatRoundingLeft) {
  EXPECT_EQ(cardinal_words(decimal_of(0.1 + 0.2)), "zero point three");
  EXPECT_EQ(cardinal_words(decimal_of(1.1 * 3)), "three point three");
}

TEST(SpokenNumber, OrdinalsEndInTheirLastWord) {
  EXPECT_EQ(ordinal_words(8), "eighth");
  EXPECT_EQ(ordinal_words(40), "fortieth");
  EXPECT_EQ(ordinal_words(100), "one hundredth");
  EXPECT_EQ(ordinal_words(1'012), "one thousand and twelfth");
}

TEST(SpokenNumber, YearsAreSaidInTwoHalves) {
  EXPECT_EQ(year_words(1066), "ten sixty six");
  EXPECT_EQ(year_words(2000), "two thousand");
  EXPECT_EQ(year_words(2010), "twenty ten");
  EXPECT_EQ(year_words(2100), "twenty one hundred");
  EXPECT_EQ(year_words(476), "four hundred and seventy six");
}

TEST(SpokenNumber, DigitsComeInGroups) {
  EXPECT_EQ(digit_words("123"), "one two three");
  EXPECT_EQ(digit_words("12345"), "one two three four five");
  EXPECT_EQ(digit_words("(65) 123-456"), "six five one two, three four five "
                                         "six");
  EXPECT_EQ(digit_words("that"), "that");
}

} // namespace

} // namespace parlour::script
