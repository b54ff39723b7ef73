#include <gmock/gmock.h>

#include "adapters/agents/component/remote_agent.hpp"
#include "runtime/plugin/test_host.hpp"
#include "tests/adapters/agents/agents_fixture.hpp"

namespace parlour::adapters::agents {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

constexpr Milliseconds patience = 10s;

Message goes(std::string place, SessionId session, Correlation correlation) {
  Message message;
  message.source = "Script";
  message.command = "Goto";
  message.params = {std::move(place)};
  message.session = std::move(session);
  message.correlation = correlation;
  return message;
}

// A porter's component, and the porter.
class RemoteAgentTest : public testing::Test {
protected:
  RemoteAgentTest() {
    ServerOptions options;
    options.accounts.push_back({"Porter", "", ""});
    options.lines = LineOptions();
    auto started = AgentServer::start(std::move(options));
    server = std::move(*started);
    plugin = remote_agent({"Porter", {"Robot"}, 8s}, server).create();
    EXPECT_TRUE(plugin->start(host, {}));
  }
  ~RemoteAgentTest() override {
    plugin->stop();
  }

  void connect(const std::string& hello = "hello,,Porter,Hello,json=1") {
    porter.emplace(server->addresses().at(0));
    porter->say(hello);
    porter->hear();
    EXPECT_TRUE(host.wait([&] { return host.is_available(); }, patience));
  }
  // The next events that the component fires.
  std::vector<Message> events(std::size_t count) {
    std::vector<Message> all;
    host.wait(
        [&] {
          for (auto& event : host.take_events())
            all.push_back(std::move(event));
          return all.size() >= count;
        },
        patience);
    return all;
  }
  // The next message that is not the link's own.
  std::string hear() {
    auto line = porter->hear();
    while (line.starts_with("ack") || line.starts_with("beat"))
      line = porter->hear();
    return line;
  }
  // The value of the attribute `c` in a line.
  static std::string correlation_in(const std::string& line) {
    const auto begin = line.find(";c=") + 3;
    return line.substr(begin, line.find_first_of(";,", begin) - begin);
  }

  std::shared_ptr<AgentServer> server;
  TestHost host;
  std::unique_ptr<IPlugin> plugin;
  std::optional<LineAgent> porter;
};

TEST_F(RemoteAgentTest, IsAvailableWhileItsAgentIsConnected) {
  EXPECT_FALSE(host.is_available());
  connect();
  porter.reset();
  EXPECT_TRUE(host.wait([&] { return !host.is_available(); }, patience));
}

TEST_F(RemoteAgentTest, WhatTheAgentAnswersBelongsToWhoAsked) {
  connect();
  plugin->receive(goes("kitchen", "ann", 3));
  const auto line = porter->hear();
  EXPECT_THAT(line, StartsWith("text;s=ann;n=1;"));
  EXPECT_THAT(line, HasSubstr(";d=8000"));
  EXPECT_THAT(line, HasSubstr(",Script,Goto,kitchen"));
  // It names another conversation, which has no effect.
  porter->say("text;n=1;s=bob;c=" + correlation_in(line) +
              ",,Porter,Arrived,kitchen");
  const auto all = events(1);
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].session, "ann");
  EXPECT_EQ(all[0].correlation, 3u);
  EXPECT_EQ(to_string(all[0]), "Porter.Arrived(kitchen)");
}

TEST_F(RemoteAgentTest, ANumberThatNobodyGaveAnswersNothing) {
  connect();
  porter->say("text;n=1;c=77,,Porter,Sensor,door,open");
  const auto all = events(1);
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].correlation, 0u);
  EXPECT_EQ(all[0].session, "");
}

TEST_F(RemoteAgentTest, AMessageWithSinksGoesToComponents) {
  connect();
  porter->say("text;n=1;k=TTS,,Porter,Speak,here I am");
  std::vector<Message> sent;
  EXPECT_TRUE(
      host.wait([&] { return !(sent = host.take_sent()).empty(); }, patience));
  EXPECT_THAT(sent[0].sinks, ElementsAre("TTS"));
  EXPECT_THAT(host.take_events(), IsEmpty());
}

TEST_F(RemoteAgentTest, ARequestOfTheAgentIsAnswered) {
  connect();
  porter->say("text;n=1;s=ann;k=Weather;c=9,,Porter,Ask,Singapore,today");
  EXPECT_TRUE(host.wait([&] { return !host.take_asked().empty(); }, patience));
  host.advance(0ms);
  const auto line = hear(); // nobody is there whom TestHost could ask
  EXPECT_THAT(line, HasSubstr(";c=9"));
  EXPECT_THAT(line, HasSubstr(",Parlour,Failed,"));
}

TEST_F(RemoteAgentTest, ARequestForSeveralIsRefused) {
  connect();
  porter->say("text;n=1;k=Weather;k=Taxi;c=9,,Porter,Ask,Singapore");
  EXPECT_THAT(hear(), HasSubstr("one component"));
  EXPECT_THAT(host.take_asked(), IsEmpty());
}

TEST_F(RemoteAgentTest, ARequestToAnAgentThatIsAwayFails) {
  plugin->receive(goes("kitchen", "ann", 3));
  const auto all = events(1);
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].command, "Failed");
  EXPECT_EQ(all[0].session, "ann");
  EXPECT_EQ(all[0].correlation, 3u);
}

TEST_F(RemoteAgentTest, AMessageThatCannotBeWrittenFails) {
  connect();
  auto message = goes("kitchen", "ann", 3);
  message.params = {Binary{"a", {}}, Binary{"b", {}}};
  plugin->receive(message);
  const auto all = events(1);
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].command, "Failed");
  EXPECT_EQ(all[0].correlation, 3u);
}

TEST_F(RemoteAgentTest, AParameterThatIsNoJsonIsAMistake) {
  connect();
  porter->say("text;n=1;c=7,,Porter,Sensor,\x01J{");
  EXPECT_THAT(hear(), StartsWith("error;c=7,,Parlour,malformed"));
  EXPECT_EQ(server->mistakes().at("malformed"), 1U);
  // As many in a row end the connection as of any other mistake.
  for (int i = 2; i < AgentExchange::max_malformed; ++i) {
    porter->say("text,,Porter,Sensor,\x01J{");
    EXPECT_THAT(hear(), StartsWith("error,,Parlour,malformed"));
  }
  porter->say("text,,Porter,Sensor,\x01J{");
  EXPECT_THAT(hear(), StartsWith("error,,Parlour,flood"));
  EXPECT_THAT(host.take_events(), IsEmpty());
  EXPECT_THAT(host.take_logs(), IsEmpty());
}

TEST_F(RemoteAgentTest, SaysThatARoleIsNotInTheSettings) {
  connect("hello,,Porter,Hello,roles=Robot Taxi Boat");
  porter->say("hello,,Porter,Hello,roles=Car");
  porter->hear();
  const auto logs = host.take_logs();
  ASSERT_EQ(logs.size(), 1u);
  EXPECT_THAT(logs[0], HasSubstr("fills Taxi, Boat;"));
}

TEST(RemoteAgent, WithoutAServerItIsAwayForEver) {
  TestHost host;
  const auto plugin = remote_agent({"Porter", {"Robot"}, 8s}, nullptr).create();
  ASSERT_TRUE(plugin->start(host, {}));
  EXPECT_FALSE(host.is_available());
  plugin->receive(goes("kitchen", "ann", 3));
  const auto events = host.take_events();
  ASSERT_EQ(events.size(), 1u);
  EXPECT_EQ(events[0].command, "Failed");
  plugin->stop();
}

} // namespace
} // namespace parlour::adapters::agents
