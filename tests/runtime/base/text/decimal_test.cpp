#include <limits>

#include <gtest/gtest.h>

#include "runtime/base/text/decimal.hpp"

namespace parlour {

namespace {

TEST(Decimal, HasTheFewestDigits) {
  EXPECT_EQ(decimal_of(0.1), (Decimal{false, "1", 0}));
  EXPECT_EQ(decimal_of(-1250.0), (Decimal{true, "125", 4}));
  EXPECT_EQ(decimal_of(std::int64_t{-1250}), (Decimal{true, "125", 4}));
  EXPECT_EQ(decimal_of(-0.0), Decimal());
  EXPECT_EQ(decimal_of(std::numeric_limits<std::int64_t>::min()).digits,
            "9223372036854775808");
}

TEST(Decimal, RoundsHalvesAwayFromZero) {
  EXPECT_EQ(rounded(decimal_of(2.675), 2), decimal_of(2.68));
  EXPECT_EQ(rounded(decimal_of(-0.05), 1), decimal_of(-0.1));
  EXPECT_EQ(rounded(decimal_of(9.99), 1), decimal_of(10.0));
  EXPECT_EQ(rounded(decimal_of(0.04), 1), Decimal());
  EXPECT_EQ(rounded(decimal_of(0.0001), 1), Decimal());
  EXPECT_EQ(rounded(decimal_of(1.5), 3), decimal_of(1.5));
}

TEST(Decimal, IsPrintedWithoutExponentWhereItCanBeRead) {
  EXPECT_EQ(decimal_text(decimal_of(1e6)), "1000000");
  EXPECT_EQ(decimal_text(decimal_of(1e20)), "100000000000000000000");
  EXPECT_EQ(decimal_text(decimal_of(1e21)), "1e+21");
  EXPECT_EQ(decimal_text(decimal_of(1.25e22)), "1.25e+22");
  EXPECT_EQ(decimal_text(decimal_of(123456789012345680000.0)),
            "123456789012345680000");
  EXPECT_EQ(decimal_text(decimal_of(0.000001)), "0.000001");
  EXPECT_EQ(decimal_text(decimal_of(-1.5e-7)), "-1.5e-7");
  EXPECT_EQ(decimal_text(decimal_of(5e-324)), "5e-324");
  EXPECT_EQ(decimal_text(Decimal()), "0");
}

TEST(Decimal, HasTwoParts) {
  EXPECT_EQ(whole_digits(decimal_of(1250.5)), "1250");
  EXPECT_EQ(fraction_digits(decimal_of(1250.5)), "5");
  EXPECT_EQ(whole_digits(decimal_of(0.05)), "0");
  EXPECT_EQ(fraction_digits(decimal_of(0.05)), "05");
  EXPECT_EQ(whole_digits(decimal_of(1200.0)), "1200");
  EXPECT_EQ(fraction_digits(decimal_of(1200.0)), "");
}

} // namespace

} // namespace parlour
