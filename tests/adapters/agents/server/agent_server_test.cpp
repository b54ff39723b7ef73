#include <future>

#include <gmock/gmock.h>

#include "adapters/agents/server/agent_server.hpp"
#include "tests/adapters/agents/agents_fixture.hpp"

namespace parlour::adapters::agents {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

TEST_F(AgentServerTest, SaysThatNobodyIsThere) {
  start({{}, LineOptions(), {}});
  server->send("Robot", command("Goto"));
  EXPECT_THAT(component->wait_for(1), ElementsAre("Goto refused: Offline"));
}

TEST_F(AgentServerTest, AComponentThatComesLaterIsTold) {
  start({{}, LineOptions(), {}});
  LineAgent robot(server->addresses().at(0));
  robot.say("hello,,Robot,Hello");
  robot.hear();
  component->wait_for(1);
  server->detach("Robot", component.get());
  robot.say("text,,Robot,Arrived");
  robot.say("shout");
  EXPECT_THAT(robot.hear(), HasSubstr("refused"));
  EXPECT_THAT(robot.hear(), HasSubstr("unknown"));
  server->attach("Robot", component);
  EXPECT_THAT(component->wait_for(1), ElementsAre("Robot online"));
}

TEST_F(AgentServerTest, WhatWasWrittenLeavesAtTheEnd) {
  start({{}, LineOptions(), {}});
  LineAgent robot(server->addresses().at(0));
  robot.say("hello,,Robot,Hello");
  robot.hear();
  component->wait_for(1);
  robot.say("shout");
  log.wait_for(1); // the answer is being written
  server.reset();
  EXPECT_THAT(robot.hear(), HasSubstr("unknown"));
}

TEST_F(AgentServerTest, RefusesOptionsThatAreWrong) {
  const auto refusal = [](ServerOptions options) {
    const auto started = AgentServer::start(std::move(options));
    return started ? "" : started.error().message;
  };
  EXPECT_THAT(refusal({{}, LineOptions{"0.0.0.0", 0, "", ""}, {}}),
              HasSubstr("other hosts"));
  EXPECT_THAT(refusal({{}, LineOptions{"somewhere", 0, "", ""}, {}}),
              HasSubstr("no address"));
  EXPECT_THAT(refusal({{}, LineOptions{"127.0.0.1", 0, "none.pem", "x"}, {}}),
              HasSubstr("none.pem"));
  EXPECT_THAT(
      refusal({{}, {}, ServerOptions::ZeroMQ{"tcp://0.0.0.0:*", "", {}}}),
      HasSubstr("other hosts"));
  EXPECT_THAT(
      refusal({{}, {}, ServerOptions::ZeroMQ{"tcp://127.0.0.1:*", "k", {}}}),
      HasSubstr("40 characters"));
  start({{}, LineOptions(), {}});
  const auto taken = server->addresses().at(0);
  const auto port = std::stoi(taken.substr(taken.rfind(':') + 1));
  EXPECT_THAT(refusal({{},
                       LineOptions{"127.0.0.1",
                                   static_cast<std::uint16_t>(port), "", ""},
                       {}}),
              HasSubstr("in use"));
}

TEST_F(AgentServerTest, StrangersAreLoggedAndCounted) {
  std::promise<std::string> line;
  start({{}, LineOptions(), {}, [&](const std::string& text) {
           line.set_value(text);
         }});
  LineAgent stranger(server->addresses().at(0));
  stranger.say("hello,,Stranger,Hello");
  EXPECT_THAT(stranger.hear(), HasSubstr("identity"));
  EXPECT_THAT(line.get_future().get(), HasSubstr("no agent is called"));
  EXPECT_EQ(server->mistakes().at("identity"), 1U);
}

// An older platform, as a newer agent sees it, and the other way round.
TEST_F(AgentServerTest, OlderAndNewerAgentsAgreeOnAVersionOrAreToldWhich) {
  start({{}, LineOptions(), {}});
  const auto answer = [&](const std::string& versions) {
    LineAgent robot(server->addresses().at(0));
    robot.say("hello,,Robot,Hello" + versions);
    return robot.hear();
  };
  EXPECT_THAT(answer(",version=7,oldest=1"), HasSubstr("Welcome,version=1"));
  EXPECT_THAT(answer(""), HasSubstr("Welcome,version=1"));
  for (const auto* versions : {",version=7,oldest=2", ",version=2",
                               ",version=0", ",version=1,oldest=2"})
    EXPECT_THAT(answer(versions), HasSubstr("error,,Parlour,version,"
                                            "\"versions 1 to 1 are spoken"))
        << versions;
  EXPECT_EQ(server->mistakes().at("version"), 4U);
}

TEST_F(AgentServerTest, RefusesWhatNobodyTakes) {
  start({{}, LineOptions(), {}});
  LineAgent robot(server->addresses().at(0));
  robot.say("hello,,Robot,Hello");
  robot.hear();
  component->wait_for(1);
  server->detach("Robot", component.get());
  robot.say("text;c=4,,Robot,Arrived");
  EXPECT_THAT(robot.hear(), StartsWith("error;c=4,,Parlour,refused"));
}

// The server and the other components live on.
TEST_F(AgentServerTest, AComponentThatThrowsHasFailed) {
  component->throws_at = "Arrived";
  start({{}, LineOptions(), {}});
  LineAgent robot(server->addresses().at(0));
  robot.say("hello,,Robot,Hello");
  robot.hear();
  robot.say("text;c=4,,Robot,Arrived");
  EXPECT_THAT(robot.hear(), StartsWith("error;c=4,,Parlour,refused"));
  EXPECT_THAT(component->wait_for(2),
              ElementsAre("Robot online", "failed: Arrived is too much"));
  auto next = std::make_shared<NotingComponent>();
  server->attach("Robot", next);
  robot.say("text,,Robot,Arrived");
  EXPECT_THAT(next->wait_for(2), ElementsAre("Robot online", "Arrived"));
}

// A component may ask for more while it is called.
TEST_F(AgentServerTest, IsCalledWithoutALock) {
  class Successor : public NotingComponent {
  public:
    Successor(AgentServer& its_server, std::shared_ptr<Component> its_next)
        : server(its_server), next(std::move(its_next)) {}
    std::optional<WireError> received(AgentMessage) override {
      server.attach("Robot", next);
      return {};
    }
    AgentServer& server;
    std::shared_ptr<Component> next;
  };
  start({{}, LineOptions(), {}});
  server->attach("Robot", std::make_shared<Successor>(*server, component));
  LineAgent robot(server->addresses().at(0));
  robot.say("hello,,Robot,Hello");
  robot.hear();
  robot.say("text,,Robot,Arrived");
  EXPECT_THAT(component->wait_for(1), ElementsAre("Robot online"));
}

// What it says within a call leaves at once, and in its order.
TEST_F(AgentServerTest, AComponentMayAnswerAtOnce) {
  class Answering : public NotingComponent {
  public:
    explicit Answering(AgentServer& its_server) : server(its_server) {}
    std::optional<WireError> received(AgentMessage message) override {
      server.send("Robot", command(message.command + "1"));
      server.send("Robot", command(message.command + "2"));
      return {};
    }
    AgentServer& server;
  };
  start({{}, LineOptions(), {}});
  server->attach("Robot", std::make_shared<Answering>(*server));
  LineAgent robot(server->addresses().at(0));
  robot.say("hello,,Robot,Hello");
  robot.hear();
  robot.say("text,,Robot,A\ntext,,Robot,B");
  EXPECT_THAT(robot.hear(), HasSubstr("A1"));
  EXPECT_THAT(robot.hear(), HasSubstr("A2"));
  EXPECT_THAT(robot.hear(), HasSubstr("B1"));
  EXPECT_THAT(robot.hear(), HasSubstr("B2"));
}

TEST_F(AgentServerTest, NobodyComesFromOutsideWithoutACredential) {
  const auto refusal = [](const char* address) {
    const auto keys = new_key_pair().value();
    const auto started = AgentServer::start(
        {{{"Robot", "", ""}},
         {},
         ServerOptions::ZeroMQ{address, keys.secret_key, {keys.public_key}},
         {}});
    return started ? "" : started.error().message;
  };
  EXPECT_THAT(refusal("tcp://0.0.0.0:*"), HasSubstr("a token or a key"));
  EXPECT_THAT(refusal("tcp://127.0.0.1:*"), "");
}

} // namespace
} // namespace parlour::adapters::agents
