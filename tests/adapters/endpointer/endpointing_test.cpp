#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/endpointer/endpointing.hpp"

namespace parlour::adapters {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr std::int64_t frame = 20;

// A stream of numbered frames in which a detector hears speech.
class EndpointingTest : public testing::Test {
protected:
  // Hears frames until this position, and notes what follows.
  void until(std::int64_t end) {
    for (; now < end; now += frame)
      note(endpointing.hear(now, now));
  }
  void speaks(std::int64_t from, std::int64_t to, std::int64_t delay = 60) {
    until(from + delay);
    endpointing.speech_started(from);
    until(to + delay);
    endpointing.speech_ended(to);
  }
  void note(const TurnSteps& steps) {
    for (const auto& step : steps) {
      if (const auto* audio = std::get_if<TurnAudio>(&step))
        audio_.push_back(audio->frame.integer_or(-1));
      else if (const auto* start = std::get_if<TurnStarted>(&step))
        seen.push_back("start " + std::to_string(start->position));
      else if (const auto* end = std::get_if<TurnEnded>(&step))
        seen.push_back("end " + std::to_string(end->position) + " at " +
                       std::to_string(now));
      else if (std::holds_alternative<Woken>(step))
        seen.push_back("woken at " + std::to_string(now));
      else if (std::holds_alternative<FellAsleep>(step))
        seen.push_back("asleep at " + std::to_string(now));
      else
        seen.push_back("dropped");
    }
  }
  // Every frame from the first to the last, once and in order.
  void expect_audio(std::int64_t first, std::int64_t last) {
    std::vector<std::int64_t> expected;
    for (auto position = first; position <= last; position += frame)
      expected.push_back(position);
    EXPECT_EQ(audio_, expected);
  }

  void may_sleep(Milliseconds after) {
    EndpointTimes times;
    times.awake = after;
    endpointing = Endpointing(times);
  }

  Endpointing endpointing{EndpointTimes{}};
  std::int64_t now = 0;
  std::vector<std::string> seen;
  std::vector<std::int64_t> audio_;
};

TEST_F(EndpointingTest, SilenceIsNoTurn) {
  until(60'000);
  EXPECT_THAT(seen, IsEmpty());
  EXPECT_THAT(audio_, IsEmpty());
}

TEST_F(EndpointingTest, ATurnHasAMarginOnBothSides) {
  speaks(1'000, 2'000);
  until(5'000);
  EXPECT_THAT(seen, ElementsAre("start 1000", "end 2000 at 2700"));
  expect_audio(700, 2'300);
}

TEST_F(EndpointingTest, AWholeSentenceEndsSooner) {
  speaks(1'000, 2'000);
  endpointing.recognised(true);
  until(5'000);
  EXPECT_THAT(seen, ElementsAre("start 1000", "end 2000 at 2300"));
}

TEST_F(EndpointingTest, WhereNoSentenceEndsItWaits) {
  speaks(1'000, 2'000);
  endpointing.recognised(false);
  until(5'000);
  EXPECT_THAT(seen, ElementsAre("start 1000", "end 2000 at 3200"));
}

TEST_F(EndpointingTest, APauseWithinATurnIsPartOfIt) {
  speaks(1'000, 2'000);
  speaks(2'600, 3'000);
  until(5'000);
  EXPECT_THAT(seen, ElementsAre("start 1000", "end 3000 at 3700"));
  expect_audio(700, 3'300);
}

// What was a sentence before the speaker went on says nothing of its end.
TEST_F(EndpointingTest, GoingOnForgetsWhatWasRecognised) {
  speaks(1'000, 2'000);
  endpointing.recognised(true);
  speaks(2'200, 3'000);
  until(5'000);
  EXPECT_THAT(seen, ElementsAre("start 1000", "end 3000 at 3700"));
}

TEST_F(EndpointingTest, ALongerPauseMakesTwoTurns) {
  speaks(1'000, 2'000);
  speaks(3'500, 4'000);
  until(6'000);
  EXPECT_THAT(seen, ElementsAre("start 1000", "end 2000 at 2700", "start 3500",
                                "end 4000 at 4700"));
}

TEST_F(EndpointingTest, ACoughDoesNotInterruptTheRobot) {
  endpointing.robot_speaks(true);
  speaks(1'000, 1'200);
  until(3'000);
  EXPECT_THAT(seen, IsEmpty());
  speaks(4'000, 5'000);
  until(7'000);
  EXPECT_THAT(seen, ElementsAre("start 4000", "end 5000 at 5700"));
}

// The turn begins while the speech goes on, 250 ms after it began.
TEST_F(EndpointingTest, SpeechInterruptsTheRobotSoon) {
  endpointing.robot_speaks(true);
  until(1'060);
  endpointing.speech_started(1'000);
  until(1'280);
  EXPECT_THAT(seen, ElementsAre("start 1000"));
  until(1'500);
  expect_audio(700, 1'480);
}

TEST_F(EndpointingTest, AShortAnswerCountsOnceTheRobotIsSilent) {
  speaks(1'000, 1'150);
  until(3'000);
  EXPECT_THAT(seen, ElementsAre("start 1000", "end 1150 at 1860"));
}

TEST_F(EndpointingTest, WhoNeverStopsIsCutAndGoesOn) {
  until(60);
  endpointing.speech_started(0);
  until(61'000);
  EXPECT_THAT(seen, ElementsAre("start 0", "end 30000 at 30000", "start 30000",
                                "end 60000 at 60000", "start 60000"));
  expect_audio(0, 60'980);
}

TEST_F(EndpointingTest, TheEndOfTheAudioEndsTheTurn) {
  until(1'060);
  endpointing.speech_started(1'000);
  until(2'000);
  note(endpointing.finish());
  EXPECT_THAT(seen, ElementsAre("start 1000", "end 1980 at 2000"));
  EXPECT_FALSE(endpointing.in_turn());
  EXPECT_THAT(endpointing.finish(), IsEmpty());
}

TEST_F(EndpointingTest, ResetDropsTheTurn) {
  endpointing.robot_speaks(true);
  until(1'060);
  endpointing.speech_started(1'000);
  until(2'000);
  note(endpointing.reset());
  until(4'000);
  EXPECT_THAT(seen, ElementsAre("start 1000", "dropped"));
  speaks(5'000, 5'200); // the robot still speaks
  until(6'000);
  EXPECT_EQ(seen.size(), 2u);
}

TEST_F(EndpointingTest, AnEndWithoutABeginningIsNothing) {
  until(1'000);
  endpointing.speech_ended(900);
  endpointing.recognised(true);
  until(3'000);
  EXPECT_THAT(seen, IsEmpty());
}

// -- asleep until its name is said --------------------------------------------

TEST_F(EndpointingTest, HearsNoTurnsAsleep) {
  may_sleep(Milliseconds(5'000));
  speaks(1'000, 2'000);
  until(60'000);
  EXPECT_TRUE(endpointing.is_asleep());
  EXPECT_THAT(seen, IsEmpty());
  EXPECT_THAT(audio_, IsEmpty());
}

// "Computer", a pause, and an order.
TEST_F(EndpointingTest, ATurnMayFollowTheWord) {
  may_sleep(Milliseconds(5'000));
  speaks(1'000, 1'500);
  until(1'800);
  endpointing.wake(1'600);
  speaks(3'000, 4'000);
  until(20'000);
  EXPECT_THAT(seen, ElementsAre("woken at 1800", "start 3000",
                                "end 4000 at 4700", "asleep at 9700"));
  expect_audio(2'700, 4'300);
}

// "Computer, turn on the light", found 300 ms after the word.
TEST_F(EndpointingTest, TheWordIsNoPartOfTheTurn) {
  may_sleep(Milliseconds(5'000));
  until(1'060);
  endpointing.speech_started(1'000);
  until(1'900);
  endpointing.wake(1'600);
  until(3'060);
  endpointing.speech_ended(3'000);
  until(5'000);
  EXPECT_THAT(seen,
              ElementsAre("woken at 1900", "start 1600", "end 3000 at 3700"));
  expect_audio(1'300, 3'300);
}

// The detector hears the end of the word a little longer than the spotter.
TEST_F(EndpointingTest, TheEndOfTheWordIsNoTurn) {
  may_sleep(Milliseconds(5'000));
  until(1'060);
  endpointing.speech_started(1'000);
  until(1'520);
  endpointing.wake(1'500);
  until(1'660);
  endpointing.speech_ended(1'600);
  speaks(5'000, 5'200);
  until(6'500);
  EXPECT_THAT(seen,
              ElementsAre("woken at 1520", "start 5000", "end 5200 at 5900"));
}

TEST_F(EndpointingTest, FallsAsleepWhereNobodySpeaks) {
  may_sleep(Milliseconds(5'000));
  until(1'000);
  endpointing.wake(1'000);
  until(3'000);
  endpointing.wake(3'000); // again
  until(9'000);
  endpointing.sleep(); // it does
  until(9'100);
  EXPECT_THAT(seen, ElementsAre("woken at 1000", "asleep at 7980"));
}

TEST_F(EndpointingTest, WhoIsSpokenToMayAnswer) {
  may_sleep(Milliseconds(5'000));
  until(1'000);
  endpointing.robot_speaks(true);
  until(9'000);
  endpointing.robot_speaks(false);
  speaks(12'000, 13'000);
  until(30'000);
  EXPECT_THAT(seen, ElementsAre("woken at 1000", "start 12000",
                                "end 13000 at 13700", "asleep at 18700"));
}

// "Good night", and what the robot answers ends later.
TEST_F(EndpointingTest, FallsAsleepWhileTheRobotSpeaks) {
  may_sleep(Milliseconds(5'000));
  until(1'000);
  endpointing.robot_speaks(true);
  until(2'000);
  endpointing.sleep();
  until(3'000);
  endpointing.robot_speaks(false);
  speaks(4'000, 5'000);
  until(9'000);
  EXPECT_THAT(seen, ElementsAre("woken at 1000", "asleep at 2000"));
}

TEST_F(EndpointingTest, FallsAsleepAfterReset) {
  may_sleep(Milliseconds(5'000));
  until(60'000);
  endpointing.wake({});
  until(61'000);
  note(endpointing.reset());
  now = 0;
  until(9'000);
  EXPECT_THAT(seen, ElementsAre("woken at 60000", "asleep at 5000"));
}

TEST_F(EndpointingTest, IsAlwaysAwakeOtherwise) {
  endpointing.sleep();
  speaks(1'000, 2'000);
  until(60'000);
  EXPECT_THAT(seen, ElementsAre("start 1000", "end 2000 at 2700"));
}

} // namespace
} // namespace parlour::adapters
