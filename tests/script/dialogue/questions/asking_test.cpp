// Questions for slots, and for what is in doubt about them (engine rule 5.9).
#include <gtest/gtest.h>

#include "tests/script/dialogue/topics_of_tests.hpp"

namespace parlour::dialogue {
namespace {

TEST(Asking, SeveralCandidatesAreAChoice) {
  World world(meeting);
  world.say(inform("Meeting",
                   {{"Host", Map{{"candidates", List{"Ann Lee", "Bob Lee"}},
                                 {"text", "Lee"}}}}));
  EXPECT_EQ(world.said(), Texts{"[ambiguous Meeting.Host {candidates: [Ann "
                                "Lee, Bob Lee], text: Lee, type: set}]"});
  world.say(inform({}, {{"Host", "Bob"}}));
  EXPECT_EQ(world.said(),
            Texts{"[confirm Meeting.Host {value: Bob Lee, type: set}]"});
}

TEST(Asking, AQuestionWithoutWordsCountsAsAsked) {
  World world(R"xml(<topic name="T"><slot name="S" type="Functional"
    question="{this.S ? 'never' : ''}"/></topic>)xml");
  world.say(inform("T", {}));
  world.said();
  world.say(inform({}, {{"S", "a"}}));
  EXPECT_EQ(world.slot("T", "S"), "a");
}

} // namespace
} // namespace parlour::dialogue
