#include <gtest/gtest.h>

#include "tools/bench/agents/raw_zeromq.hpp"

namespace parlour::tools {
namespace {

TEST(RawZeroMQ, measures_both_ways) {
  for (const RawZeroMQ way : {RawZeroMQ{1, true}, RawZeroMQ{6, false}}) {
    const auto exchanged = raw_zeromq_exchange(way, {1000, 100});
    ASSERT_TRUE(exchanged) << exchanged.error().message;
    EXPECT_GT(exchanged->messages_per_second, 0);
    EXPECT_GT(exchanged->median_microseconds, 0);
  }
}

} // namespace
} // namespace parlour::tools
