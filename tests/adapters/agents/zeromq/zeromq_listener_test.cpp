#include <gmock/gmock.h>

#include "adapters/agents/zeromq/zeromq_listener.hpp"
#include "tests/adapters/agents/agents_fixture.hpp"

namespace parlour::adapters::agents {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

using ZeroMQListenerTest = AgentServerTest;

TEST_F(ZeroMQListenerTest, SpeaksByZeroMQ) {
  start({{}, {}, ServerOptions::ZeroMQ()});
  FrameAgent robot(server->addresses().at(0));
  robot.say("hello,,Robot,Hello,incarnation=aa");
  EXPECT_THAT(robot.hear(), StartsWith("welcome,,Parlour,Welcome,version=1"));
  EXPECT_THAT(component->wait_for(1), ElementsAre("Robot online"));
  robot.say("text;n=1,,Robot,Arrived,lobby");
  EXPECT_THAT(component->wait_for(1), ElementsAre("Arrived"));
  EXPECT_EQ(robot.hear(), "ack;a=1");
  server->send("Robot", command("Goto"));
  EXPECT_EQ(robot.hear(), "text;n=1;a=1,,Robot,Goto");
}

TEST_F(ZeroMQListenerTest, PacksForWhoeverReadsIt) {
  start({{}, {}, ServerOptions::ZeroMQ()});
  FrameAgent robot(server->addresses().at(0));
  robot.say("hello,,Robot,Hello,incarnation=aa,packed=1");
  EXPECT_THAT(robot.hear(), HasSubstr("packed=1"));
  EXPECT_THAT(component->wait_for(1), ElementsAre("Robot online"));
  robot.say_packed("text;n=1,,Robot,Seen\ntext;n=2,,Robot,Lost\nshout\n");
  EXPECT_THAT(component->wait_for(2), ElementsAre("Seen", "Lost"));
  EXPECT_THAT(robot.hear(),
              AllOf(StartsWith("error,,Parlour,unknown"), EndsWith("\n")));
  EXPECT_EQ(robot.hear(), "ack;a=2\n");
  server->send("Robot", command("Goto"));
  EXPECT_EQ(robot.hear(), "text;n=1;a=2,,Robot,Goto\n");
}

// A closed connection takes nothing of what was packed behind.
TEST_F(ZeroMQListenerTest, NothingIsTakenBehindAClosingMistake) {
  start({{}, {}, ServerOptions::ZeroMQ()});
  FrameAgent robot(server->addresses().at(0));
  robot.say("hello,,Robot,Hello,incarnation=aa,packed=1");
  robot.hear();
  component->wait_for(1);
  robot.say_packed("text,,Porter,Seen\ntext,,Robot,Arrived\n");
  EXPECT_THAT(component->wait_for(1), ElementsAre("offline"));
  EXPECT_THAT(robot.hear(), StartsWith("error,,Parlour,identity"));
  robot.say("hello,,Robot,Hello,incarnation=aa");
  EXPECT_THAT(component->wait_for(1), ElementsAre("Robot online"));
}

TEST_F(ZeroMQListenerTest, LetsInWhoHasAKey) {
  const auto own = new_key_pair().value();
  const auto robots = new_key_pair().value();
  const auto strangers = new_key_pair().value();
  start({{},
         {},
         ServerOptions::ZeroMQ{
             "tcp://127.0.0.1:*", own.secret_key, {robots.public_key}}});
  FrameAgent stranger(server->addresses().at(0), strangers, own.public_key);
  stranger.say("hello,,Robot,Hello");
  EXPECT_THAT(log.wait_for(1), ElementsAre(HasSubstr("no agent has its key")));
  EXPECT_GE(server->mistakes().at("identity"), 1U);
  FrameAgent robot(server->addresses().at(0), robots, own.public_key);
  robot.say("hello,,Robot,Hello");
  EXPECT_THAT(robot.hear(), StartsWith("welcome"));
  EXPECT_THAT(component->wait_for(1), ElementsAre("Robot online"));
}

TEST_F(ZeroMQListenerTest, KnowsWhatIsLoopback) {
  const auto refused = [](const std::string& address) {
    const auto started = AgentServer::start(
        {{}, {}, ServerOptions::ZeroMQ{address, "", {}}, {}});
    return !started &&
           started.error().message.find("other hosts") != std::string::npos;
  };
  EXPECT_TRUE(refused("tcp://localhost.example.org:*"));
  EXPECT_TRUE(refused("tcp://127.example.org:*"));
  EXPECT_TRUE(refused("tcp://[::]:*"));
  EXPECT_FALSE(refused("tcp://[::1]:*"));
  EXPECT_FALSE(refused("tcp://127.0.0.2:*"));
}

} // namespace
} // namespace parlour::adapters::agents
