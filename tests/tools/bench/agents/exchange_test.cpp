#include <gtest/gtest.h>

#include "tools/bench/agents/exchange.hpp"

namespace parlour::tools {
namespace {

TEST(Exchange, takes_the_middle_and_the_slow_end) {
  Exchanged exchanged;
  std::vector<double> times;
  for (int i = 100; i > 0; --i)
    times.push_back(i);
  set_round_trips(exchanged, times);
  EXPECT_EQ(exchanged.median_microseconds, 51);
  EXPECT_EQ(exchanged.p99_microseconds, 100);
  set_round_trips(exchanged, {});
  EXPECT_EQ(exchanged.p99_microseconds, 100);
}

} // namespace
} // namespace parlour::tools
