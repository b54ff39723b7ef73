#include "script/dialogue/saved/reactions_of.hpp"
#include "tests/script/dialogue/saved/round_trip.hpp"

namespace parlour::dialogue {
namespace {

TEST(ReactionsOf, HandlersComeBeforeStates) {
  const auto program = small_program();
  const auto all = reactions_of(*program);
  ASSERT_EQ(all.size(), 3u);
  EXPECT_EQ(all[0], &program->handlers[0].reactions[0]);
  EXPECT_EQ(all[1], &program->states[0].messages[0]);
  EXPECT_EQ(all[2], &program->states[0].messages[1]);
}

} // namespace
} // namespace parlour::dialogue
