#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tools/parlour/robot_voice.hpp"

namespace parlour::tools {
namespace {

TEST(RobotVoice, says_a_turn_a_line) {
  std::ostringstream out;
  RobotVoice voice(out, {});
  voice.say("one\ntwo");
  voice.say("three");
  EXPECT_EQ(out.str(), "one two\nthree\n");
}

TEST(RobotVoice, tells_once_that_nobody_listens) {
  int closed = 0;
  std::stringbuf unwritable(std::ios::in);
  std::ostream nowhere(&unwritable);
  RobotVoice lost(nowhere, [&] { ++closed; });
  lost.say("one");
  lost.say("two");
  EXPECT_EQ(closed, 1);
}

} // namespace
} // namespace parlour::tools
