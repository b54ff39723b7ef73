// What follows a filling event (engine rule 5).
#include <gtest/gtest.h>

#include "tests/script/dialogue/conversation_world.hpp"

namespace parlour::dialogue {
namespace {

TEST(Settling, FilledMayGoOnInsteadOfCompleting) {
  World world(R"xml(
    <topic name="T"><slot name="A" type="Functional" question="A?"/>
      <slot name="B" question="B?"/>
      <filled><if cond="not this.B"><ask slot="B"/></if></filled>
      <completed><speak param="Done."/></completed></topic>)xml");
  world.say(inform("T", {{"A", 1}}));
  EXPECT_EQ(world.said(), Texts{"B?"});
  world.say(inform({}, {{"B", 2}}));
  EXPECT_EQ(world.said(), Texts{"Done."});
}

} // namespace
} // namespace parlour::dialogue
