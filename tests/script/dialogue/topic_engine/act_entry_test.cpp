// Who gets an act first (engine rule 2).
#include <gtest/gtest.h>

#include "tests/script/dialogue/conversation_world.hpp"

namespace parlour::dialogue {
namespace {

TEST(ActEntry, AStateThatCapturesKeepsActsFromTheTopics) {
  WorldOptions options;
  options.start = "Menu";
  World world(R"xml(
    <state name="Menu" capture="true"><Messages><component><Dialogue>
      <inform><speak param="Mine."/></inform>
    </Dialogue></component></Messages></state>
    <topic name="Taxi"><slot name="Street" type="Functional"
      question="Which street?"/></topic>)xml",
              options);
  world.say(inform("Taxi", {}));
  EXPECT_EQ(world.said(), Texts{"Mine."});
  world.say(act("request", "Taxi"));
  EXPECT_EQ(world.said(), Texts{"[no_match]"});
}

} // namespace
} // namespace parlour::dialogue
