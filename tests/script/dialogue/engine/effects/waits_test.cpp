// Who wants out ends what scripts wait for (engine rule 2.5).
#include <gtest/gtest.h>

#include "tests/script/dialogue/topics_of_tests.hpp"

namespace parlour::dialogue {
namespace {

constexpr const char* waits_everywhere = R"xml(
  <topic name="T">
    <slot name="S" type="Functional" question="What?"/>
    <filled><request module="Slow" command="Go"/></filled>
    <completed><speak param="Done."/></completed>
  </topic>
  <handler name="H"><messages><component><Bell>
    <Rings><try><request module="Slow" command="Come"/>
      <speak param="It came."/>
      <catch name="e"><speak param="{e.kind}"/></catch></try></Rings>
    <Asks><try><confirm question="Sure?"/>
      <catch name="e"><speak param="{e.kind}"/></catch></try></Asks>
    </Bell></component></messages></handler>)xml";

TEST(Waits, AScriptThatWaitsForAYesHearsThatItIsCancelled) {
  World world(transfer);
  world.say(inform("Transfer", {{"Host", "Ann"}}));
  EXPECT_EQ(world.said(), Texts{"Call Ann?"});
  world.say("cancel");
  EXPECT_EQ(world.said(), (Texts{"Cancelled.", "[cancelled Transfer]"}));
}

TEST(Waits, OfThePipelineLaneOnlyThoseForTheUserEnd) {
  World world(waits_everywhere);
  world.components["Slow"] = {};
  world.event("Bell", "Rings");
  const auto asked = world.messages.back().correlation;
  world.event("Bell", "Asks");
  EXPECT_EQ(world.said(), Texts{"Sure?"});
  world.say("cancel");
  EXPECT_EQ(world.said(), (Texts{"[cancelled]", "Cancelled"}));
  world.event("Slow", "Arrived", {}, asked);
  EXPECT_EQ(world.said(), Texts{"It came."});
}

// The answer that comes after all is an event as any other.
TEST(Waits, TheAnswerToAnEndedRequestIsWantedNoMore) {
  World world(waits_everywhere);
  world.components["Slow"] = {};
  world.say(inform("T", Map{{"S", "a"}}));
  const auto asked = world.messages.back().correlation;
  world.say("cancel");
  world.said();
  world.event("Slow", "Gone", {}, asked);
  EXPECT_EQ(world.said(), Texts{});
  EXPECT_FALSE(world.conversation->waits_for_answer());
}

} // namespace
} // namespace parlour::dialogue
