#include <gtest/gtest.h>

#include "adapters/push_to_talk/talk_switch.hpp"

namespace parlour::adapters {
namespace {

using std::chrono::milliseconds;
using Change = TalkSwitch::Change;

TalkSwitch::Moment at(int time) {
  return TalkSwitch::Moment() + milliseconds(1'000'000 + time);
}

TEST(TalkSwitchTest, TalksWhileTheKeyIsHeld) {
  TalkSwitch key(TalkBy::hold);
  EXPECT_EQ(key.released(), Change());
  EXPECT_EQ(key.pressed(), Change(true));
  EXPECT_EQ(key.pressed(), Change());
  EXPECT_EQ(key.released(), Change(false));
  EXPECT_EQ(key.due(), std::nullopt);
}

TEST(TalkSwitchTest, TalksFromOnePressToTheNext) {
  TalkSwitch key(TalkBy::twice);
  EXPECT_EQ(key.pressed(), Change(true));
  EXPECT_EQ(key.released(), Change());
  EXPECT_EQ(key.pressed(), Change(false));
  EXPECT_EQ(key.released(), Change());
  EXPECT_EQ(key.pressed(), Change(true));
}

TEST(TalkSwitchTest, ATerminalsKeyIsHeldAsLongAsItIsRepeated) {
  TalkSwitch key(TalkBy::hold);
  EXPECT_EQ(key.typed(at(0)), Change(true));
  EXPECT_EQ(key.due(), at(750));
  EXPECT_EQ(key.typed(at(600)), Change()); // the first repetition
  EXPECT_EQ(key.typed(at(640)), Change());
  EXPECT_EQ(key.due(), at(840));
  EXPECT_EQ(key.passed(at(839)), Change());
  EXPECT_EQ(key.passed(at(840)), Change(false));
  EXPECT_EQ(key.due(), std::nullopt);
  EXPECT_EQ(key.passed(at(2'000)), Change());
}

TEST(TalkSwitchTest, WhatATerminalRepeatsIsNoSecondPress) {
  TalkSwitch key(TalkBy::twice);
  EXPECT_EQ(key.typed(at(0)), Change(true));
  EXPECT_EQ(key.typed(at(40)), Change());
  EXPECT_EQ(key.typed(at(230)), Change());
  EXPECT_EQ(key.due(), std::nullopt);
  EXPECT_EQ(key.typed(at(500)), Change(false));
  EXPECT_EQ(key.typed(at(1'500)), Change(true));
}

TEST(TalkSwitchTest, AKeyThatIsHeldIsPressedOnce) {
  TalkSwitch key(TalkBy::twice);
  EXPECT_EQ(key.typed(at(0)), Change(true));
  for (int time = 600; time < 3'000; time += 40) // as a terminal repeats it
    EXPECT_EQ(key.typed(at(time)), Change()) << time;
  EXPECT_EQ(key.typed(at(5'000)), Change(false));
  EXPECT_EQ(key.typed(at(5'660)), Change());
  EXPECT_EQ(key.typed(at(6'000)), Change(true));
  EXPECT_EQ(key.reset(), Change(false));
  EXPECT_EQ(key.typed(at(6'100)), Change(true));
  EXPECT_EQ(key.typed(at(6'700)), Change());
}

TEST(TalkSwitchTest, ForgetsTheKey) {
  TalkSwitch key(TalkBy::hold);
  EXPECT_EQ(key.reset(), Change());
  EXPECT_EQ(key.typed(at(0)), Change(true));
  EXPECT_EQ(key.reset(), Change(false));
  EXPECT_EQ(key.due(), std::nullopt);
  TalkSwitch other(TalkBy::twice);
  EXPECT_EQ(other.pressed(), Change(true));
  EXPECT_EQ(other.reset(), Change(false));
  EXPECT_EQ(other.pressed(), Change(true));
}

} // namespace
} // namespace parlour::adapters
