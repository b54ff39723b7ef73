#include <gtest/gtest.h>

#include "tools/bench/agents/agent_workload.hpp"

namespace parlour::tools {
namespace {

// An error would say that a message or an answer was lost.
TEST(AgentWorkload, loses_nothing) {
  for (const auto transport : {AgentTransport::lines, AgentTransport::zeromq}) {
    const auto exchanged = agents_exchange(transport, {5000, 100});
    ASSERT_TRUE(exchanged) << exchanged.error().message;
    EXPECT_GT(exchanged->messages_per_second, 0);
    EXPECT_GT(exchanged->cpu_nanoseconds, 0);
    EXPECT_GT(exchanged->median_microseconds, 0);
  }
}

} // namespace
} // namespace parlour::tools
