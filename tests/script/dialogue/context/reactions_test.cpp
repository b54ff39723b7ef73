#include <gtest/gtest.h>

#include "script/dialogue/context/reactions.hpp"
#include "tests/script/dialogue/conversation_world.hpp"

namespace parlour::dialogue {
namespace {

struct ReactionsTest : testing::Test {
  ReactionsTest()
      : world("<state name='Open'><messages><component><Bell><Rings/></Bell>"
              "</component></messages></state>"
              "<state name='Shut' capture='all'><messages><component><Bell>"
              "<Rings/></Bell></component></messages></state>"
              "<handler name='H'><messages><component><Bell><Rings/></Bell>"
              "</component></messages></handler>",
              WorldOptions()),
        interpreter(world.program),
        context(interpreter, world.program, {}, world), reactions(context) {
    world.components["Bell"] = {"Door"};
  }
  void enter(const char* state) {
    context.states.enter(world.program->state(state));
  }

  World world;
  script::Interpreter interpreter;
  DialogueContext context;
  Reactions reactions;
};

TEST_F(ReactionsTest, WithoutAStateThereAreTheHandlers) {
  EXPECT_EQ(reactions.matches("Bell", "Rings").size(), 1u);
  EXPECT_FALSE(reactions.state_listens("Bell", "Rings"));
  EXPECT_FALSE(reactions.listens("Bell", "Stops"));
}

TEST_F(ReactionsTest, TheActiveStateComesFirst) {
  enter("Open");
  const auto found = reactions.matches("Bell", "Rings");
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].visit, context.states.visit());
  EXPECT_FALSE(found[0].captures);
  EXPECT_EQ(found[1].visit, 0u);
  EXPECT_TRUE(reactions.state_listens("Bell", "Rings"));
}

TEST_F(ReactionsTest, AStateThatCapturesAllLeavesNothingToHandlers) {
  enter("Shut");
  const auto found = reactions.matches("Bell", "Rings");
  ASSERT_EQ(found.size(), 1u);
  EXPECT_TRUE(found[0].captures);
  EXPECT_TRUE(reactions.state_listens("Bell", "Stops"));
  EXPECT_FALSE(reactions.listens("Bell", "Stops"));
}

TEST_F(ReactionsTest, AHandlerThatIsNotRegisteredHearsNothing) {
  reactions.register_handler("H", false);
  EXPECT_FALSE(reactions.listens("Bell", "Rings"));
  reactions.register_handler("H", true);
  EXPECT_TRUE(reactions.listens("Bell", "Rings"));
}

} // namespace
} // namespace parlour::dialogue
