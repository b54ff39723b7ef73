#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tools/parlour/load/playable.hpp"

namespace parlour::tools {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Conversation read(const std::string& text) {
  auto parsed = parse_conversation(text, "one.txt");
  EXPECT_TRUE(parsed.errors.empty());
  return parsed.conversation;
}

TEST(Playable, IsWhatIsTypedAndLetsNoTimePass) {
  EXPECT_FALSE(why_unplayable(read("R: Hello.\nU: one\nexpect state Bye\n")));
  EXPECT_EQ(why_unplayable(read("R: Hello.\nwait 3s\n")),
            "line 2: it lets time pass");
  EXPECT_EQ(why_unplayable(read("U: a\nclock 2026-11-21 10:00\n")),
            "line 2: it lets time pass");
  EXPECT_THAT(*why_unplayable(read("event Robot Arrived\n")),
              HasSubstr("a component or agent"));
  EXPECT_THAT(*why_unplayable(read("P: half\n")), HasSubstr("needs a voice"));
  EXPECT_THAT(*why_unplayable(read("U(voice=rms): a\n")),
              HasSubstr("needs a voice"));
}

TEST(Playable, HasTurnsWithWhatIsExpected) {
  const auto conversation =
      read("R: Hello.\nU: one\nU: two\nR: First.\nexpect state Bye\nR~ S.*\n"
           "U: three\n");
  const auto made = played(conversation);
  ASSERT_EQ(made.turns.size(), 3);
  EXPECT_TRUE(made.turns[0].lines.empty());
  EXPECT_EQ(made.turns[0].answers.at(0)->text, "Hello.");
  EXPECT_THAT(made.turns[1].lines, ElementsAre("one", "two"));
  EXPECT_EQ(made.turns[1].answers.size(), 2);
  EXPECT_THAT(made.turns[2].lines, ElementsAre("three"));
  EXPECT_EQ(made.unchecked, 1);
}

} // namespace
} // namespace parlour::tools
