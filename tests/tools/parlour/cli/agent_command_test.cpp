#include "adapters/agents/server/agent_server.hpp"
#include "tests/tools/parlour/command_fixture.hpp"

namespace parlour::tools {
namespace {

using testing::HasSubstr;

TEST_F(CommandTest, agent_needs_an_address_that_can_be_read) {
  EXPECT_EQ(call({"agent", "LogRobot", "--connect", "127.0.0.1:1"}),
            exit_code::usage);
  EXPECT_THAT(err_.str(), HasSubstr("say tcp://HOST:PORT"));
  EXPECT_EQ(call({"agent", "LogRobot", "--connect", "tcp://nowhere"}),
            exit_code::usage);
  EXPECT_THAT(err_.str(), HasSubstr("nowhere"));
}

TEST_F(CommandTest, agent_needs_a_plugin_and_its_options) {
  EXPECT_EQ(call({"agent", "LogRobt"}), exit_code::usage);
  EXPECT_THAT(err_.str(), HasSubstr("LogRobot"));
  EXPECT_EQ(call({"agent", "LogRobot", "--option", "wheels=4"}),
            exit_code::usage);
  EXPECT_THAT(err_.str(), HasSubstr("wheels"));
}

// The whole conversation is in remote_agent_test.py.
TEST_F(CommandTest, agent_ends_where_the_platform_does_not_want_it) {
  using namespace adapters::agents;
  ServerOptions options;
  options.lines = LineOptions();
  const auto server = AgentServer::start(std::move(options));
  ASSERT_TRUE(server);
  EXPECT_EQ(
      call({"agent", "LogRobot", "--connect", (*server)->addresses().at(0)}),
      exit_code::wrong);
  EXPECT_THAT(err_.str(), HasSubstr("no agent is called 'LogRobot'"));
}

} // namespace
} // namespace parlour::tools
