// What follows silence: reprompts, resumed topics, new topics (engine rule 5).
#include <gtest/gtest.h>

#include "tests/script/dialogue/topics_of_tests.hpp"

namespace parlour::dialogue {
namespace {

using namespace std::chrono_literals;

constexpr const char* resuming = R"xml(
  <topic name="Survey" resume="{policy}">
    <slot name="Answer" type="Functional" question="Which answer?"/></topic>
  <topic name="Weather"><slot name="Day" type="Functional"/></topic>)xml";

std::string with_policy(const char* policy) {
  std::string script = resuming;
  return script.replace(script.find("{policy}"), 8, policy);
}

TEST(Silence, SilenceAfterAConfirmationAsksItAgain) {
  World world(meeting);
  world.say(inform("Meeting", {{"Host", "Ann Lee"}}));
  world.said();
  world.advance(8s);
  EXPECT_EQ(world.said(),
            Texts{"[confirm Meeting.Host {value: Ann Lee, type: set}]"});
  world.say("confirm");
  EXPECT_EQ(world.said(), (Texts{"Host Ann Lee.", "From?"}));
}

TEST(Silence, ResumeAsksFirst) {
  for (bool yes : {true, false}) {
    World world(with_policy("ask"), starting_with("Survey"));
    world.say(inform("Weather", {{"Day", "Monday"}}));
    EXPECT_EQ(world.said(), Texts{"Which answer?"});
    world.advance(2s);
    EXPECT_EQ(world.said(), Texts{"[resume Survey]"});
    world.say(yes ? "confirm" : "deny");
    EXPECT_EQ(world.said(),
              yes ? Texts{"Which answer?"} : Texts{"[cancelled Survey]"});
  }
}

TEST(Silence, ResumeNever) {
  World world(with_policy("never"), starting_with("Survey"));
  world.say(inform("Weather", {{"Day", "Monday"}}));
  world.said();
  world.advance(50s);
  EXPECT_EQ(world.said(), Texts{});
}

} // namespace
} // namespace parlour::dialogue
