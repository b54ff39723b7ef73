// What scripts read of their conversation.
#include <gtest/gtest.h>

#include "script/dialogue/context/script_view.hpp"
#include "tests/script/dialogue/conversation_world.hpp"

namespace parlour::dialogue {
namespace {

struct ScriptViewTest : testing::Test {
  ScriptViewTest()
      : world("<state name='Here'/><topic name='T'><slot name='S'/></topic>"),
        interpreter(world.program),
        context(interpreter, world.program,
                {.session = "s2", .seed = 1, .phrases = {}}, world),
        frames(context, interpreter), view(context, frames) {}

  Value system(script::SystemVariable variable,
               const script::ActivationContext& where = {}) {
    return view.system(where, variable);
  }

  // A script of the topic, perhaps of its slot.
  static script::ActivationContext of_topic(SlotId slot = script::no_id) {
    script::ActivationContext where;
    where.topic = 0;
    where.slot = slot;
    return where;
  }

  World world;
  script::Interpreter interpreter;
  DialogueContext context;
  TopicFrames frames;
  ScriptView view;
};

using enum script::SystemVariable;

TEST_F(ScriptViewTest, ASlotIsThatOfTheScriptsTopic) {
  frames.change(0, {.kind = FrameChange::Kind::set, .slot = 0, .value = 4});
  EXPECT_EQ(view.slot(0, 0), 4);
  EXPECT_TRUE(view.slot(script::no_id, 0).is_unknown());
}

TEST_F(ScriptViewTest, TheTopicIsTheScriptsOwnElseTheCurrentOne) {
  EXPECT_TRUE(system(topic).is_unknown());
  EXPECT_EQ(system(topic, of_topic()), "T");
  frames.order().activate(0);
  EXPECT_EQ(system(topic), "T");
  EXPECT_EQ(system(script::SystemVariable::slot, of_topic(0)), "S");
}

TEST_F(ScriptViewTest, SessionTimeAndSeedAreTheConversations) {
  context.now = 17;
  EXPECT_EQ(view.now(), 17);
  EXPECT_EQ(system(session), "s2");
  EXPECT_TRUE(system(state).is_unknown());
  DialogueContext same_seed(interpreter, world.program,
                            {.session = "s3", .seed = 1, .phrases = {}}, world);
  ScriptView other(same_seed, frames);
  EXPECT_EQ(view.random(), other.random());
}

} // namespace
} // namespace parlour::dialogue
