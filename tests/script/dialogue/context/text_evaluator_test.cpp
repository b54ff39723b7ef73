// Texts and conditions: they read what scripts read, and do nothing.
#include <gtest/gtest.h>

#include "script/dialogue/context/text_evaluator.hpp"
#include "tests/script/dialogue/conversation_world.hpp"

namespace parlour::dialogue {
namespace {

constexpr const char* application =
    "<function name='loud'><speak param='Oh!'/><return expr=\"'A'\"/>"
    "</function>"
    "<function name='noted'><log param='asked'/><return expr=\"'B'\"/>"
    "</function>"
    "<topic name='T'>"
    "<slot name='Said' type='Functional' question='{this.Said}?'/>"
    "<slot name='Loud' type='Functional' question='{loud()}?'/>"
    "<slot name='Noted' type='Functional' question='{noted()}?'/>"
    "</topic>";

struct TextEvaluatorTest : testing::Test {
  TextEvaluatorTest()
      : world(application), interpreter(world.program),
        context(interpreter, world.program, {}, world), inbox(context.turns),
        messenger(context, inbox), frames(context, interpreter),
        view(context, frames), texts(context, interpreter, messenger, view) {}

  CodeId question(const char* slot) const {
    const auto& topic = world.program->topics[0];
    return topic.slots[topic.slot(slot)].question;
  }

  World world;
  script::Interpreter interpreter;
  DialogueContext context;
  Inbox inbox;
  Messenger messenger;
  TopicFrames frames;
  ScriptView view;
  TextEvaluator texts;
};

TEST_F(TextEvaluatorTest, ATextReadsTheTopicsSlots) {
  frames.change(0,
                {.kind = FrameChange::Kind::set, .slot = 0, .value = "Hall"});
  EXPECT_EQ(texts.text_of(question("Said"), 0), "Hall?");
  EXPECT_EQ(texts.text_of(script::no_code, 0), "");
}

TEST_F(TextEvaluatorTest, AStatementInATextIsRefusedAndTold) {
  EXPECT_EQ(texts.text_of(question("Loud"), 0), "");
  ASSERT_EQ(world.seen(InspectionKind::error).size(), 1u);
  EXPECT_NE(world.seen(InspectionKind::error)[0].find("can only compute"),
            std::string::npos);
  EXPECT_TRUE(world.said().empty());
}

TEST_F(TextEvaluatorTest, ALineForTheLogHurtsNobody) {
  EXPECT_EQ(texts.text_of(question("Noted"), 0), "B?");
  EXPECT_EQ(world.seen(InspectionKind::log), Texts{"info: asked"});
}

TEST_F(TextEvaluatorTest, AConditionThatFailsDoesNotHoldAndIsAnError) {
  EXPECT_FALSE(texts.holds(question("Loud"), {}, 0, 0));
  ASSERT_TRUE(inbox.has_internal());
  EXPECT_EQ(inbox.take_internal().message->command, "Error");
  EXPECT_TRUE(texts.holds(question("Noted"), {}, 0, 0));
}

} // namespace
} // namespace parlour::dialogue
