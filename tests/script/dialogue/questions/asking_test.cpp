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

// A handler takes its words and says nothing: silence still leads somewhere.
TEST(Asking, AQuestionWithoutWordsCountsAsAsked) {
  World world(R"xml(
    <topic name="T"><slot name="S" type="Functional" question="S?">
      <noinput><speak param="Hello?"/></noinput></slot></topic>
    <handler name="N"><messages><component><NLG><Speak>
      <log param="swallowed"/></Speak></NLG></component></messages>
    </handler>)xml");
  world.components["Phrases"] = {"NLG"};
  world.answers = [](const Message& asked) {
    Message reply;
    reply.source = "Phrases";
    reply.command = "Speak";
    reply.params = {asked.params[0]};
    reply.session = asked.session;
    reply.correlation = asked.correlation;
    return std::vector<Message>{reply};
  };
  world.say(inform("T", {}));
  EXPECT_EQ(world.said(), Texts{});
  world.advance(std::chrono::seconds(9));
  EXPECT_EQ(world.said(), Texts{"Hello?"});
}

} // namespace
} // namespace parlour::dialogue
