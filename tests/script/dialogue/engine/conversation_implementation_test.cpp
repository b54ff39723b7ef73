// What happens with each input, and when nothing comes any more.
#include <gtest/gtest.h>

#include "tests/script/dialogue/conversation_world.hpp"

namespace parlour::dialogue {
namespace {

using namespace std::chrono_literals;

TEST(ConversationInputs, AComponentThatNeverAnswersDoesNotKeepItOpen) {
  WorldOptions options;
  options.start = "S";
  World world(R"xml(<state name="S"><Messages><component><ASR>
      <RecognitionResult><post module="NLU" command="DoNLU"/><consume/>
      </RecognitionResult></ASR></component></Messages></state>)xml",
              options);
  world.components["Grammar"] = {"NLU"};
  world.say("thank");
  world.advance(69s);
  EXPECT_FALSE(world.has_ended);
  world.advance(1s);
  EXPECT_TRUE(world.has_ended);
}

} // namespace
} // namespace parlour::dialogue
