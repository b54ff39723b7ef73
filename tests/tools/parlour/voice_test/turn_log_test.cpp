#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tools/parlour/voice_test/turn_log.hpp"

namespace parlour::tools {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;
using testing::IsEmpty;

class TurnLogTest : public testing::Test {
protected:
  void note(std::string command, std::vector<Value> params = {},
            std::vector<std::string> sinks = {}) {
    auto message = std::make_shared<Message>();
    message->time = time;
    message->command = std::move(command);
    message->params = std::move(params);
    message->sinks = std::move(sinks);
    log.note({InspectionKind::message, "s", "", "", message, ""}, real);
  }

  TurnLog log;
  Timestamp time = 10'000;
  TurnLog::RealTime real;
};

TEST_F(TurnLogTest, a_turn_lasts_until_it_is_recognised) {
  EXPECT_FALSE(log.in_turn());
  note("TurnStarted", {100});
  EXPECT_TRUE(log.in_turn());
  note("TurnEnded", {900});
  EXPECT_TRUE(log.in_turn());
  note("RecognitionResult", {"hello", 1});
  EXPECT_FALSE(log.in_turn());
  note("TurnStarted", {2'100});
  note("TurnEnded", {2'900});
  note("Rejected", {"noise"});
  EXPECT_FALSE(log.in_turn());
  EXPECT_EQ(log.recognised(), 2u);
  EXPECT_THAT(log.heard(), ElementsAre("hello", ""));
  note("TurnStarted", {4'100});
  note("TurnDropped", {4'900});
  EXPECT_FALSE(log.in_turn());
}

TEST_F(TurnLogTest, notes_what_was_understood) {
  note("FrameInfo", {Map{{"act", "greet"}}, Map{{"act", "bye"}}});
  note("NoResult", {"hm"});
  note("FrameInfo", {Map{{"act", "thank"}}}, {"somebody"});
  EXPECT_THAT(log.understood(), ElementsAre("greet; bye", "nothing"));
}

TEST_F(TurnLogTest, knows_whether_the_robot_speaks) {
  log.released(1, "Hello.");
  EXPECT_TRUE(log.robot_speaks());
  EXPECT_FALSE(log.robot_sounds());
  note("Started", {1});
  EXPECT_TRUE(log.robot_sounds());
  note("Finished", {1}); // of the voice
  EXPECT_TRUE(log.robot_sounds());
  note("Finished", {1, 500, false, "Hello."});
  EXPECT_FALSE(log.robot_speaks());
  EXPECT_FALSE(log.robot_sounds());
}

TEST_F(TurnLogTest, what_was_interrupted_is_no_answer) {
  log.released(1, "Hello.");
  log.released(2, "Bye.");
  note("Finished", {1, 500, true, ""});
  EXPECT_THAT(log.answers(), ElementsAre("Bye."));
}

TEST_F(TurnLogTest, takes_the_time_from_the_last_sound_to_the_first) {
  note("TurnStarted", {100});
  log.line_ended(time);
  time += 300;
  note("TurnEnded", {900});
  note("RecognitionResult", {"hello", 1});
  log.released(1, "Hello.");
  log.released(2, "Hello again.");
  time += 20;
  real += 5ms;
  note("Started", {1});
  note("Started", {2});
  ASSERT_EQ(log.latencies().size(), 1u);
  EXPECT_EQ(log.latencies()[0].pause, 300ms);
  EXPECT_EQ(log.latencies()[0].waiting, 20ms);
  EXPECT_EQ(log.latencies()[0].computing, 5ms);
  EXPECT_EQ(log.latencies()[0].all(), 325ms);
}

TEST_F(TurnLogTest, a_row_begins_with_nothing) {
  note("TurnStarted", {100});
  note("RecognitionResult", {"hello", 1});
  log.released(1, "Hello.");
  log.begin_row();
  EXPECT_THAT(log.heard(), IsEmpty());
  EXPECT_THAT(log.answers(), IsEmpty());
  EXPECT_FALSE(log.in_turn());
  EXPECT_TRUE(log.robot_speaks());
}

} // namespace
} // namespace parlour::tools
