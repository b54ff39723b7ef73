#include <asio.hpp>
#include <gmock/gmock.h>

#include "adapters/agents/client/agent_host.hpp"

namespace parlour::adapters::agents {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class AgentHostTest : public testing::Test {
protected:
  static Message to(const std::string& sink, const std::string& command) {
    Message message;
    message.sinks = {sink};
    message.command = command;
    return message;
  }
  // What becomes of a request.
  PluginHost::Reaction noting() {
    return [this](Expected<Message> outcome) {
      outcomes.push_back(outcome ? to_string(*outcome)
                                 : to_string(outcome.error()));
    };
  }
  AgentMessage answer_to(const AgentMessage& request, std::string command) {
    AgentMessage answer;
    answer.component = "Weather";
    answer.command = std::move(command);
    answer.correlation = request.correlation;
    return answer;
  }

  asio::io_context context;
  bool has_room = true;
  std::vector<AgentMessage> sent;
  std::vector<std::string> logs;
  std::vector<std::string> outcomes;
  AgentHost host{
      "Porter",
      "/data",
      context,
      {.send =
           [this](AgentMessage message) {
             if (has_room)
               sent.push_back(std::move(message));
             return has_room;
           },
       .available = [](bool) {},
       .failed = [](const std::string&) {},
       .log = [this](const std::string& text) { logs.push_back(text); }}};
};

TEST_F(AgentHostTest, SpeaksAsTheAgent) {
  auto event = to("TTS", "Seen");
  event.source = "Somebody";
  event.session = "ann";
  event.correlation = 4;
  host.fire_event(event);
  host.send_message(to("TTS", "Speak"));
  ASSERT_EQ(sent.size(), 2u);
  EXPECT_EQ(sent[0].component, "Porter");
  EXPECT_EQ(sent[0].session, "ann");
  EXPECT_EQ(sent[0].correlation, 4u);
  EXPECT_THAT(sent[0].sinks, IsEmpty());
  EXPECT_THAT(sent[1].sinks, ElementsAre("TTS"));
}

TEST_F(AgentHostTest, ARequestEndsByItsAnswer) {
  host.ask(to("Weather", "Ask"), 1h, noting());
  ASSERT_EQ(sent.size(), 1u);
  EXPECT_EQ(sent[0].deadline, 3'600'000u);
  EXPECT_TRUE(host.take_answer(answer_to(sent[0], "Report")));
  EXPECT_TRUE(host.take_answer(answer_to(sent[0], "Report"))); // once only
  EXPECT_THAT(outcomes, ElementsAre("Weather.Report()"));
}

TEST_F(AgentHostTest, ARequestThatNobodyCanTakeFails) {
  host.ask(to("Weather", "Ask"), 1h, noting());
  auto answer = answer_to(sent[0], "Failed");
  answer.component = "Parlour";
  answer.parameters = {"nobody is there"};
  host.take_answer(answer);
  EXPECT_THAT(outcomes, ElementsAre(HasSubstr("nobody is there")));
}

TEST_F(AgentHostTest, ARequestEndsByAnError) {
  host.ask(to("Weather", "Ask"), 1h, noting());
  auto error = answer_to(sent[0], "refused");
  error.kind = MessageKind::error;
  error.parameters = {"nobody takes it"};
  EXPECT_TRUE(host.take_answer(error));
  EXPECT_THAT(outcomes, ElementsAre(HasSubstr("nobody takes it")));
}

TEST_F(AgentHostTest, RequestsEndWhereThePlatformIsAway) {
  host.ask(to("Weather", "Ask"), 1h, noting());
  host.ask(to("Weather", "Ask"), 1h, noting());
  EXPECT_NE(sent[0].correlation, sent[1].correlation);
  host.end_requests();
  host.end_requests();
  EXPECT_THAT(outcomes,
              ElementsAre(HasSubstr("not there"), HasSubstr("not there")));
}

TEST_F(AgentHostTest, ARequestEndsInTime) {
  host.ask(to("Weather", "Ask"), 1ms, noting());
  context.run();
  EXPECT_THAT(outcomes, ElementsAre(HasSubstr("in time")));
}

TEST_F(AgentHostTest, WhatCannotBeSentIsTold) {
  has_room = false;
  host.fire_event(to("", "Seen"));
  EXPECT_THAT(logs, ElementsAre(HasSubstr("Seen is not sent")));
  host.ask(to("Weather", "Ask"), 1ms, noting());
  context.run();
  EXPECT_EQ(outcomes.size(), 1u);
}

TEST_F(AgentHostTest, ACommandIsNoAnswer) {
  AgentMessage command;
  command.sinks = {"Porter"};
  command.correlation = 1;
  EXPECT_FALSE(host.take_answer(command));
}

TEST_F(AgentHostTest, DelaysRunUnlessTheyAreCancelled) {
  std::vector<int> ran;
  host.after(2ms, [&] { ran.push_back(2); });
  host.after(0ms, [&] { ran.push_back(1); });
  host.cancel(host.after(1ms, [&] { ran.push_back(3); }));
  context.run();
  EXPECT_THAT(ran, ElementsAre(1, 2));
}

} // namespace
} // namespace parlour::adapters::agents
