#include <gtest/gtest.h>

#include "tests/tools/corpus/corpus_fixture.hpp"
#include "tools/corpus/world.hpp"

namespace parlour::tools::corpus {
namespace {

using namespace std::chrono_literals;

class CorpusWorld : public testing::Test {
protected:
  static List act(const char* kind, Value topic = {}, Map slots = {}) {
    return {Map{{"act", kind}, {"topic", topic}, {"slots", slots}}};
  }
  std::string last() const {
    return world.said.empty() ? "" : world.said.back().text;
  }

  test::TemporaryFolder folder;
  World world{compile_table(folder), nullptr};
};

TEST_F(CorpusWorld, ActsFillTheSlotsOfTheConversation) {
  world.open();
  EXPECT_TRUE(world.say(act("inform", "Table", {{"People", "2"}})));
  EXPECT_EQ(world.slot("Table", "People"), Value("2"));
  EXPECT_EQ(last(), "When?");
}

TEST_F(CorpusWorld, WritesSucceedOrFail) {
  world.open();
  world.writes_succeed = false;
  world.say(act("inform", "Table", {{"People", "2"}, {"Time", "5 pm"}}));
  world.say(act("confirm"));
  EXPECT_EQ(last(), "When?");
  world.writes_succeed = true;
  world.say(act("inform", "Table", {{"Time", "6 pm"}}));
  world.say(act("confirm"));
  EXPECT_EQ(last(), "It is booked.");
}

TEST_F(CorpusWorld, TimeBringsBackWhatWasLeft) {
  world.open();
  world.say(act("inform", "Table", {{"People", "2"}}));
  world.say(act("inform", "Hours", {{"Day", "Monday"}}));
  EXPECT_EQ(last(), "At nine.");
  EXPECT_TRUE(world.advance(3s));
  EXPECT_EQ(last(), "When?");
}

TEST_F(CorpusWorld, ErrorsOfScriptsAreNoted) {
  world.open();
  world.say(act("request", "Table"));
  ASSERT_FALSE(world.errors.empty());
  EXPECT_NE(world.errors[0].find("no idea"), std::string::npos);
}

} // namespace
} // namespace parlour::tools::corpus
