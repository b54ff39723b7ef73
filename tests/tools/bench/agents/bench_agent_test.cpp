#include <future>

#include <gtest/gtest.h>

#include "tools/bench/agents/bench_agent.hpp"

namespace parlour::tools {
namespace {

using adapters::agents::AgentMessage;

TEST(BenchAgent, speaks_with_the_platform) {
  for (const auto transport : {AgentTransport::lines, AgentTransport::zeromq}) {
    auto server = start_bench_server(transport, 2);
    ASSERT_TRUE(server);
    std::promise<std::string> heard;
    auto agent = BenchAgent::connect(
        **server, transport, bench_agent_name(1),
        [&](AgentMessage&& message) { heard.set_value(message.command); });
    ASSERT_TRUE(agent) << name_of(transport);
    AgentMessage message;
    message.command = "Seen";
    EXPECT_TRUE(agent->connection().send(std::move(message)));
    EXPECT_EQ(heard.get_future().get(), "Seen");
  }
}

} // namespace
} // namespace parlour::tools
