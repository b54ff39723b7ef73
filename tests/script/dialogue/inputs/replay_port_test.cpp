#include <gtest/gtest.h>

#include "script/dialogue/inputs/replay_port.hpp"
#include "tests/script/dialogue/conversation_world.hpp"

namespace parlour::dialogue {
namespace {

TEST(ReplayPort, GivesTheNotedAnswersInTheirOrder) {
  World world("");
  ReplayPort port(world.program);
  PortAnswers answers;
  answers.letters = "pPyn012sf";
  answers.posted = {{Message()}};
  answers.failures = {{ErrorKind::network, "no", {}}};
  port.expect(answers);
  EXPECT_TRUE(port.post({}).empty());
  EXPECT_EQ(port.post({}).size(), 1u);
  EXPECT_TRUE(port.reachable("A"));
  EXPECT_FALSE(port.is_source("A", "B"));
  EXPECT_EQ(port.reply_to_request({}), Reply::none);
  EXPECT_EQ(port.reply_to_request({}), Reply::answer);
  EXPECT_EQ(port.reply_to_request({}), Reply::refusal);
  EXPECT_TRUE(port.send_socket(1, "a"));
  EXPECT_EQ(port.send_socket(1, "a").error().message, "no");
  EXPECT_EQ(port.difference(), "it says or wants something else than it did");
}

TEST(ReplayPort, NoticesAQuestionThatWasAnother) {
  World world("");
  ReplayPort port(world.program);
  PortAnswers answers;
  answers.letters = "p";
  port.expect(answers);
  EXPECT_FALSE(port.reachable("A"));
  EXPECT_EQ(port.difference(),
            "it asks its surroundings something else than it did");
}

TEST(ReplayPort, AsksSomebodyElse) {
  World world("");
  ReplayPort port(world.program);
  port.ask(world);
  EXPECT_TRUE(port.reachable("ASR"));
  EXPECT_TRUE(port.is_source("ASR", "Keyboard"));
  EXPECT_TRUE(port.post({}).empty());
  EXPECT_EQ(port.difference(), std::nullopt);
}

} // namespace
} // namespace parlour::dialogue
