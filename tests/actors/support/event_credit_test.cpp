#include <gtest/gtest.h>

#include "actors/support/event_credit.hpp"

namespace parlour::actors {
namespace {

int spend_all(EventCredit& credit, Timestamp now) {
  int events = 0;
  while (credit.spend(now))
    ++events;
  return events;
}

TEST(EventCredit, IsFullAtFirstAndFillsAsTimePasses) {
  EventCredit credit;
  EXPECT_EQ(spend_all(credit, 5'000), EventCredit::capacity);
  EXPECT_EQ(spend_all(credit, 5'000), 0);
  EXPECT_EQ(spend_all(credit, 5'010), EventCredit::each_second / 100);
  EXPECT_EQ(spend_all(credit, 1'000'000), EventCredit::capacity);
}

TEST(EventCredit, IsEarnedByWork) {
  EventCredit credit;
  spend_all(credit, 0);
  credit.earn();
  EXPECT_EQ(spend_all(credit, 0), EventCredit::each_message);
}

TEST(EventCredit, IsNoMoreThanItsCapacity) {
  EventCredit credit;
  credit.earn();
  EXPECT_EQ(spend_all(credit, 0), EventCredit::capacity);
}

} // namespace
} // namespace parlour::actors
