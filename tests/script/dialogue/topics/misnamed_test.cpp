#include <gtest/gtest.h>

#include "script/dialogue/topics/misnamed.hpp"
#include "tests/script/dialogue/conversation_world.hpp"

namespace parlour::dialogue {
namespace {

constexpr const char* taxi =
    "<topic name='Taxi'><slot name='Time' type='Functional' question='When?'/>"
    "<completed><speak param='At {this.Time}.'/></completed></topic>";

Act named(const char* topic, const char* slot = nullptr) {
  Act act;
  act.topic = topic;
  if (slot)
    act.slots.push_back({.slot = slot,
                         .value = "3",
                         .confidence = {},
                         .text = {},
                         .candidates = {}});
  return act;
}

TEST(Misnamed, TopicsAndSlotsThatThereAreNot) {
  const World world(taxi);
  EXPECT_FALSE(misnamed(*world.program, named("")));
  EXPECT_FALSE(misnamed(*world.program, named("Taxi", "Time")));
  const auto topic = misnamed(*world.program, named("Taxy"));
  ASSERT_TRUE(topic);
  EXPECT_EQ(topic->kind, ErrorKind::range);
  EXPECT_EQ(topic->message, "there is no topic 'Taxy' for this frame, did you "
                            "mean 'Taxi'?");
  const auto slot = misnamed(*world.program, named("Taxi", "Tyme"));
  ASSERT_TRUE(slot);
  EXPECT_NE(slot->message.find("has no slot 'Tyme'"), std::string::npos);
}

// Who listens to Dialogue may know the name; if he leaves it to the topics, it
// is wrong all the same, and no other topic takes it.
TEST(Misnamed, IsToldWhereAReactionDidNotTakeTheFrame) {
  World world(std::string(taxi) +
              "<handler name='H'><messages><component><Dialogue><inform/>"
              "</Dialogue></component></messages></handler>");
  world.say(inform("Taxy", Map{{"Time", "3"}}));
  EXPECT_TRUE(world.slot("Taxi", "Time").is_unknown());
  ASSERT_EQ(world.seen(InspectionKind::error).size(), 1u);
  EXPECT_NE(world.seen(InspectionKind::error)[0].find("no topic 'Taxy'"),
            std::string::npos);
}

} // namespace
} // namespace parlour::dialogue
