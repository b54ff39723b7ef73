// Asking which of several topics was meant (understanding, "Score").
#include <gtest/gtest.h>

#include "tests/script/dialogue/conversation_world.hpp"

namespace parlour::dialogue {
namespace {

using namespace std::chrono_literals;

TEST(Clarification, AsksWhichTopicIsMeant) {
  constexpr const char* two = R"xml(
    <topic name="Call"><slot name="Person" type="Functional"/>
      <completed><speak param="Calling {this.Person}."/></completed></topic>
    <topic name="Visit"><slot name="Host" type="Functional"/>
      <completed><speak param="Visiting {this.Host}."/></completed></topic>
    )xml";
  auto unclear = [](double second) {
    return Map{{"act", "inform"},
               {"topic", "Call"},
               {"confidence", 0.8},
               {"slots", Map{{"Person", slot_value("Ho", 1)}}},
               {"alternatives",
                List{Map{{"act", "inform"},
                         {"topic", "Visit"},
                         {"confidence", second},
                         {"slots", Map{{"Host", slot_value("Ho", 1)}}}}}}};
  };
  World world(two);
  world.say(unclear(0.75));
  EXPECT_EQ(world.said(), Texts{"[clarify {topics: [Call, Visit]}]"});
  world.say(inform("Visit", {}));
  EXPECT_EQ(world.said(), Texts{"Visiting Ho."});
  world.say(unclear(0.75));
  world.say("confirm"); // which of them is not said
  EXPECT_EQ(world.said(), (Texts{"[clarify {topics: [Call, Visit]}]",
                                 "[clarify {topics: [Call, Visit]}]"}));
  world.say(List{Map{{"act", "confirm"}}, inform("Call", {})});
  EXPECT_EQ(world.said(), Texts{"Calling Ho."});
  world.say(unclear(0.6)); // far enough behind
  EXPECT_EQ(world.said(), Texts{"Calling Ho."});
  world.say(unclear(0.75));
  world.advance(8s);
  world.say("deny"); // neither
  EXPECT_EQ(world.said(),
            (Texts{"[clarify {topics: [Call, Visit]}]",
                   "[clarify {topics: [Call, Visit]}]", "[acknowledge]"}));
}

} // namespace
} // namespace parlour::dialogue
