// What a question that is not answered leads to (engine rule 5).
#include <gtest/gtest.h>

#include "tests/script/dialogue/conversation_world.hpp"

namespace parlour::dialogue {
namespace {

TEST(TopicRepair, ALadderOfTheSettingsReplacesTheStandardOne) {
  WorldOptions options;
  options.settings = R"xml(<ladder>
    <step><speak param="What? ({_SLOT})"/></step>
    <step><end/></step></ladder>)xml";
  World world(R"xml(
    <topic name="Booking"><slot name="Place" type="Functional"
      question="Where?"/></topic>)xml",
              options);
  world.say(inform("Booking", {}));
  world.said();
  world.say(act("nonsense"));
  EXPECT_EQ(world.said().front(), "What? (Place)");
  EXPECT_FALSE(world.has_ended);
  world.say(act("nonsense"));
  EXPECT_TRUE(world.has_ended);
}

} // namespace
} // namespace parlour::dialogue
