#include <gtest/gtest.h>

#include "tools/bench/agents/raw_tcp.hpp"

namespace parlour::tools {
namespace {

TEST(RawTcp, measures_both_ways) {
  const auto exchanged = raw_tcp_exchange({10'000, 100});
  ASSERT_TRUE(exchanged) << exchanged.error().message;
  EXPECT_GT(exchanged->messages_per_second, 0);
  EXPECT_GT(exchanged->median_microseconds, 0);
  EXPECT_GE(exchanged->p99_microseconds, exchanged->median_microseconds);
}

} // namespace
} // namespace parlour::tools
