#include "tests/tools/parlour/voice_test/spoken_application.hpp"
#include "tools/parlour/voice_test/row_runner.hpp"

namespace parlour::tools {
namespace {

using namespace std::chrono_literals;
using testing::AllOf;
using testing::ElementsAre;
using testing::Ge;
using testing::IsEmpty;
using testing::Le;
using testing::StartsWith;

class RowRunnerTest : public SpokenTest {
protected:
  RowRunnerTest() {
    for (const auto* line : {"one", "two", "three"})
      EXPECT_TRUE(bank.speak(line, "rms"));
  }
  std::vector<Row> by_voice(const std::string& text,
                            std::size_t typed_rows = 0) {
    const auto told = conversation(text);
    const auto expected = hold_by_text(typed, told).rows;
    const auto held =
        hold_by_voice(spoken, told, {&bank, "rms", noise, false, nullptr},
                      expected, typed_rows);
    EXPECT_EQ(held.trouble, "");
    return held.rows;
  }

  SpeechBank bank{std::make_shared<test::HummingVoices>()};
  adapters::Sound noise;
};

TEST_F(RowRunnerTest, holds_a_conversation_by_text) {
  const auto held = hold_by_text(
      typed, conversation("U: one\nR: You said one.\nU: two\nU: three\n"
                          "R~ .*two.\nR~ .*three.\n"));
  ASSERT_EQ(held.rows.size(), 2u);
  EXPECT_EQ(held.rows[0].line, 1u);
  EXPECT_THAT(held.rows[0].said, ElementsAre("one"));
  EXPECT_THAT(held.rows[0].answers, ElementsAre("You said one."));
  EXPECT_THAT(held.rows[1].said, ElementsAre("two", "three"));
  EXPECT_THAT(held.rows[1].answers,
              ElementsAre("You said two.", "You said three."));
}

TEST_F(RowRunnerTest, holds_a_conversation_by_voice) {
  *hears = {"one", "two"};
  const auto rows = by_voice("U: one\nR: You said one.\nU: two\nR~ .*\n");
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_THAT(rows[1].heard, ElementsAre("two"));
  EXPECT_THAT(rows[1].answers, ElementsAre("You said two."));
  ASSERT_EQ(rows[1].latencies.size(), 1u);
  EXPECT_THAT(rows[1].latencies[0].pause, AllOf(Ge(600ms), Le(900ms)));
  EXPECT_THAT(rows[1].latencies[0].waiting, AllOf(Ge(20ms), Le(100ms)));
}

TEST_F(RowRunnerTest, stops_behind_a_row_that_went_otherwise) {
  *hears = {"won", "two"};
  const auto rows = by_voice("U: one\nR: You said one.\nU: two\nR~ .*\n");
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_THAT(rows[0].heard, ElementsAre("won"));
  EXPECT_THAT(rows[0].answers, ElementsAre("You said won."));
}

TEST_F(RowRunnerTest, types_what_comes_before) {
  *hears = {"two"};
  const auto rows = by_voice("U: one\nR: You said one.\nU: two\nR~ .*\n", 1);
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_THAT(rows[0].heard, ElementsAre("one"));
  EXPECT_THAT(rows[0].latencies, IsEmpty());
  EXPECT_THAT(rows[1].answers, ElementsAre("You said two."));
}

// The robot says that it has not understood (engine rule 3.2).
TEST_F(RowRunnerTest, waits_no_longer_for_what_was_rejected) {
  *hears = {""};
  const auto rows = by_voice("U: one\nR: You said one.\n");
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_THAT(rows[0].heard, ElementsAre(""));
  EXPECT_THAT(rows[0].answers, ElementsAre(StartsWith("Sorry")));
}

// The next line of a row cuts in.
TEST_F(RowRunnerTest, what_was_interrupted_is_no_answer) {
  *hears = {"one", "two"};
  const auto rows = by_voice("U: one\nU: two\nR~ .*\nR~ .*\n");
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_THAT(rows[0].heard, ElementsAre("one", "two"));
  EXPECT_THAT(rows[0].answers, ElementsAre("You said two."));
}

TEST_F(RowRunnerTest, says_what_cannot_be_spoken) {
  EXPECT_EQ(unspeakable(conversation("U: one\n")), "");
  EXPECT_EQ(unspeakable(conversation("U: one\nP: two\n")),
            "line 2 says what a recogniser or a speaker reports");
}

} // namespace
} // namespace parlour::tools
