#include <gtest/gtest.h>

#include "adapters/database/lost_transactions.hpp"

namespace parlour::adapters {
namespace {

TEST(LostTransactions, AreKnownUntilForgotten) {
  LostTransactions lost;
  EXPECT_FALSE(lost.has("s1"));
  lost.add("s1");
  lost.add("s1");
  EXPECT_TRUE(lost.has("s1"));
  lost.forget("s1");
  EXPECT_FALSE(lost.has("s1"));
}

TEST(LostTransactions, AreKnownOfTheLatestOnly) {
  LostTransactions lost;
  for (int i = 0; i <= 1'000; ++i)
    lost.add("s" + std::to_string(i));
  EXPECT_FALSE(lost.has("s0"));
  EXPECT_TRUE(lost.has("s1"));
  EXPECT_TRUE(lost.has("s1000"));
}

} // namespace
} // namespace parlour::adapters
