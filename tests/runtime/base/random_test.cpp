#include <set>

#include <gtest/gtest.h>

#include "runtime/base/random.hpp"

namespace parlour {
namespace {

// The published sequence of SplitMix64.
TEST(Random, GivesTheSameNumbersEverywhere) {
  Random random(1234567);
  EXPECT_EQ(random.next(), 6457827717110365317u);
  EXPECT_EQ(random.next(), 3203168211198807973u);
  EXPECT_EQ(random.next(), 9817491932198370423u);
}

TEST(Random, GoesOnFromItsState) {
  Random random(7);
  random.next();
  Random other(random.state());
  EXPECT_EQ(random.next(), other.next());
}

TEST(Random, FractionsAreSpreadBetweenZeroAndOne) {
  Random random(1);
  double sum = 0;
  std::set<double> seen;
  for (int i = 0; i < 1000; ++i) {
    const auto fraction = random.fraction();
    EXPECT_GE(fraction, 0);
    EXPECT_LT(fraction, 1);
    sum += fraction;
    seen.insert(fraction);
  }
  EXPECT_NEAR(sum / 1000, 0.5, 0.05);
  EXPECT_EQ(seen.size(), 1000u);
}

} // namespace
} // namespace parlour
