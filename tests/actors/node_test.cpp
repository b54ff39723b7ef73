#include "actors/node.hpp"
#include "tests/actors/house_fixture.hpp"

namespace parlour::actors {
namespace {

using NodeTest = HouseTest;

TEST_F(NodeTest, AnswersAUserTurn) {
  start(echo);
  EXPECT_THAT(say({"hello"}), ElementsAre("You said: hello"));
}

TEST_F(NodeTest, AnswersARowOfTurnsInOrder) {
  start(echo);
  EXPECT_THAT(say({"one", "two"}),
              ElementsAre("You said: one", "You said: two"));
}

} // namespace
} // namespace parlour::actors
