// Events and acts that scripts fire, and messages that they keep.
#include <gtest/gtest.h>

#include "script/dialogue/engine/effects/reaction_effects.hpp"
#include "tests/script/dialogue/bell.hpp"
#include "tests/script/dialogue/topics_of_tests.hpp"

namespace parlour::dialogue {
namespace {

TEST(ReactionEffects, ConsumeCountsAlsoAfterAWait) {
  World world(std::string(transfer) + R"xml(
    <handler name="H"><messages><component><Dialogue><inform><consume/>
      <confirm question="Sure?"><yes><speak param="Well."/></yes></confirm>
    </inform></Dialogue></component></messages></handler>)xml");
  world.say(inform("Hours", {{"Day", slot_value("Monday", 1)}}));
  EXPECT_EQ(world.said(), Texts{"Sure?"});
  world.say("confirm");
  EXPECT_EQ(world.said(), Texts{"Well."});
  EXPECT_EQ(world.slot("Hours", "Day"), Value());
}

TEST(ReactionEffects, EventsOfScripts) {
  Bell world("<fire event='Rung' param='5'/>", R"xml(
    <handler name="E"><messages><component><Script><Rung>
      <speak param="Rung {_LPARAM1}."/></Rung></Script></component></messages>
    </handler>)xml");
  world.ring();
  EXPECT_EQ(world.said(), Texts{"Rung 5."});
}

TEST(ReactionEffects, AScriptsOwnErrorEventNeedsNoParameter) {
  World world(R"xml(<handler name="H"><messages><component><Bell><Rings>
    <fire event="Error"/></Rings></Bell></component></messages></handler>)xml");
  world.components["Bell"] = {};
  world.event("Bell", "Rings");
  EXPECT_EQ(world.said(), Texts{"[unavailable {reason: unknown}]"});
  EXPECT_FALSE(world.has_ended);
}

} // namespace
} // namespace parlour::dialogue
