#include <gtest/gtest.h>

#include "script/dialogue/inputs/recording_port.hpp"
#include "tests/script/dialogue/conversation_world.hpp"

namespace parlour::dialogue {
namespace {

TEST(RecordingPort, NotesWhatIsAnsweredAtOnce) {
  World world("");
  world.answers = [](const Message& message) {
    return message.command == "Ask" ? std::vector<Message>{Message()}
                                    : std::vector<Message>{};
  };
  RecordingPort port(world);
  Message ask;
  ask.command = "Ask";
  EXPECT_EQ(port.post(ask).size(), 1u);
  EXPECT_TRUE(port.post({}).empty());
  EXPECT_TRUE(port.reachable("ASR"));
  EXPECT_FALSE(port.is_source("ASR", "SQLite"));
  EXPECT_TRUE(port.send_socket(1, "text"));
  const auto answers = port.take_answers();
  EXPECT_EQ(answers.letters, "Ppyns");
  EXPECT_EQ(answers.posted.size(), 1u);
  EXPECT_EQ(port.take_answers().letters, "");
}

TEST(RecordingPort, TellsApartWhatIsWanted) {
  World world("");
  world.repeats = false; // timers of nobody ring there
  RecordingPort port(world);
  const auto nothing = port.take_answers().wishes;
  port.start_timer(1, 5, TimerOwner::engine);
  const auto one = port.take_answers().wishes;
  port.start_timer(1, 6, TimerOwner::engine);
  const auto other = port.take_answers().wishes;
  port.start_timer(1, 5, TimerOwner::engine);
  EXPECT_EQ(port.take_answers().wishes, one);
  EXPECT_NE(one, other);
  EXPECT_NE(one, nothing);
}

} // namespace
} // namespace parlour::dialogue
