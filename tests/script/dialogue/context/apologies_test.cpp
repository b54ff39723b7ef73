#include <gtest/gtest.h>

#include "script/dialogue/context/apologies.hpp"
#include "tests/script/dialogue/conversation_world.hpp"

namespace parlour::dialogue {
namespace {

using namespace std::chrono_literals;

TEST(Apologies, AreRarerEachTimeThatNobodySpeaks) {
  Apologies apologies;
  std::vector<Timestamp> made;
  for (Timestamp second = 0; second < 100; ++second)
    if (apologies.due(second * 1000))
      made.push_back(second);
  EXPECT_EQ(made, (std::vector<Timestamp>{0, 10, 30, 70}));
}

TEST(Apologies, ComeAnewWhenTheUserHasSpoken) {
  Apologies apologies;
  EXPECT_TRUE(apologies.due(5));
  EXPECT_FALSE(apologies.due(6));
  apologies.user_speaks();
  EXPECT_TRUE(apologies.due(7));
  EXPECT_FALSE(apologies.due(10'006));
  EXPECT_TRUE(apologies.due(10'007));
}

constexpr const char* failing = R"xml(
  <handler name="H"><messages><component>
    <Bell><Rings><throw expr="'no bell'"/></Rings></Bell>
  </component></messages></handler>
  <topic name="T"><slot name="S"><filled><throw expr="'no topic'"/></filled>
  </slot></topic>)xml";

TEST(Apologies, AreOneForAFloodOfErrors) {
  World world(failing);
  for (int i = 0; i < 100; ++i)
    world.event("Bell", "Rings");
  EXPECT_EQ(world.said(), Texts{"[unavailable {reason: no bell}]"});
  EXPECT_EQ(world.seen(InspectionKind::error).size(), 100u);
  world.say(inform("T", {{"S", 1}}));
  EXPECT_EQ(world.said(), Texts{"[unavailable {reason: no topic}]"});
}

TEST(Apologies, AreOneForWhatFailsInOneBreath) {
  World world(failing);
  for (int i = 0; i < 100; ++i)
    world.queue(inform("T", {{"S", i}}));
  world.run();
  EXPECT_EQ(world.said(), Texts{"[unavailable {reason: no topic}]"});
}

TEST(Apologies, AreOneForWhatIsNotUnderstoodInOneBreath) {
  World world(failing);
  for (int i = 0; i < 100; ++i)
    world.queue(act("inform"));
  world.run();
  EXPECT_EQ(world.said(), Texts{"[no_match]"});
  world.say(act("inform"));
  EXPECT_EQ(world.said(), Texts{"[no_match]"});
}

// Of what is asked too: one step of the ladder, not a hundred.
TEST(Apologies, AQuestionComesOnceAfterOneBreath) {
  World world(R"xml(<topic name="T"><slot name="S" type="Functional"
    question="S?"><nomatch count="1"><speak param="Pardon?"/></nomatch>
    <nomatch count="2"><speak param="Never."/></nomatch></slot></topic>)xml");
  world.say(inform("T", {}));
  EXPECT_EQ(world.said(), Texts{"S?"});
  for (int i = 0; i < 100; ++i)
    world.queue(act("inform"));
  world.run();
  EXPECT_EQ(world.said(), Texts{"Pardon?"});
}

} // namespace
} // namespace parlour::dialogue
