#include <gmock/gmock.h>

#include "tools/parlour/application/agent_listener.hpp"

namespace parlour::tools {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

AgentsSettings one_agent() {
  AgentsSettings settings;
  settings.lines = "127.0.0.1:0";
  settings.zeromq = "127.0.0.1:*";
  settings.agents.push_back({.name = "Porter", .token = "t", .key = "k"});
  settings.place = {"settings.xml", 3, 1};
  return settings;
}

TEST(AgentListener, GivesTheServerWhatTheSettingsSay) {
  auto settings = one_agent();
  settings.certificate = "own.pem";
  settings.private_key = "/keys/own.pem";
  settings.secret_key = "s";
  const auto options = server_options(settings, "/app");
  ASSERT_TRUE(options);
  ASSERT_EQ(options->accounts.size(), 1u);
  EXPECT_EQ(options->accounts[0].token, "t");
  EXPECT_EQ(options->lines->address, "127.0.0.1");
  EXPECT_EQ(options->lines->port, 0);
  EXPECT_EQ(options->lines->certificate, "/app/own.pem");
  EXPECT_EQ(options->lines->private_key, "/keys/own.pem");
  EXPECT_EQ(options->zeromq->address, "tcp://127.0.0.1:*");
  EXPECT_EQ(options->zeromq->secret_key, "s");
  EXPECT_THAT(options->zeromq->allowed_keys, ElementsAre("k"));
}

TEST(AgentListener, LeavesOutWhatIsOff) {
  auto settings = one_agent();
  settings.lines.clear();
  EXPECT_FALSE(server_options(settings, "/app")->lines);
  settings.zeromq.clear();
  EXPECT_FALSE(server_options(settings, "/app")->zeromq);
}

TEST(AgentListener, NamesAnAddressThatCannotBeRead) {
  for (const auto* wrong : {"somewhere", "127.0.0.1:http", "127.0.0.1:70000"}) {
    auto settings = one_agent();
    settings.lines = wrong;
    const auto options = server_options(settings, "/app");
    ASSERT_FALSE(options) << wrong;
    EXPECT_EQ(options.error().place.line, 3u);
  }
}

TEST(AgentListener, Listens) {
  const auto server = listen_for_agents(one_agent(), "/app", "", {});
  ASSERT_TRUE(server) << server.error().message;
  EXPECT_THAT((*server)->addresses(),
              ElementsAre(StartsWith("tcp://127.0.0.1:"),
                          StartsWith("tcp://127.0.0.1:")));
  const auto elsewhere =
      listen_for_agents(one_agent(), "/app", "127.0.0.1:0", {});
  ASSERT_TRUE(elsewhere);
  EXPECT_EQ((*elsewhere)->addresses().size(), 1u);
}

TEST(AgentListener, ListensToNobodyWithoutAgents) {
  const auto server = listen_for_agents({}, "/app", "", {});
  ASSERT_TRUE(server);
  EXPECT_EQ(*server, nullptr);
}

TEST(AgentListener, SaysWhyNobodyCanConnect) {
  auto settings = one_agent();
  settings.lines = "0.0.0.0:0";
  const auto server = listen_for_agents(settings, "/app", "", {});
  ASSERT_FALSE(server);
  EXPECT_THAT(server.error().message, HasSubstr("other hosts"));
  EXPECT_EQ(server.error().place.line, 3u);
}

TEST(AgentListener, OpensTapsWhereTheyAreWanted) {
  EXPECT_EQ(open_tap({}, "").value(), nullptr);
  EXPECT_THAT(open_tap({}, "127.0.0.1:0").value()->address(),
              StartsWith("tcp://127.0.0.1:"));
  AgentsSettings settings;
  settings.place = {"settings.xml", 3, 1};
  settings.taps = "127.0.0.1:0";
  EXPECT_NE(open_tap(settings, "").value(), nullptr);
  settings.taps = "0.0.0.0:0";
  const auto refused = open_tap(settings, "");
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, HasSubstr("listen on 127.0.0.1"));
  EXPECT_EQ(refused.error().place.line, 3u);
}

} // namespace
} // namespace parlour::tools
