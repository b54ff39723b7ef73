#include "tests/tools/parlour/voice_test/spoken_application.hpp"
#include "tools/parlour/conversation_test/conversation_runner.hpp"
#include "tools/parlour/voice_test/spoken_lines.hpp"

namespace parlour::tools {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;

class SpokenLinesTest : public SpokenTest {
protected:
  TestSuite suite(const std::string& text) {
    TestSuite made;
    made.conversations.push_back(conversation(text));
    return made;
  }
  ConversationResult hold(const std::string& text) {
    const auto held = suite(text);
    SpokenLines lines(spoken, held, std::make_shared<test::HummingVoices>());
    EXPECT_THAT(lines.findings(), SizeIs(0));
    Coverage coverage(*typed.program);
    return hold_conversation(typed, held.conversations[0], coverage,
                             {Words::as_written, false, &lines});
  }
  std::string failure(const std::string& text) {
    const auto result = hold(text);
    return result.failure ? std::to_string(result.failure->line) + ": " +
                                result.failure->found
                          : "passed";
  }
};

TEST_F(SpokenLinesTest, a_line_is_spoken_among_others_that_are_typed) {
  *hears = {"won"};
  EXPECT_EQ(failure("U: one\nR: You said one.\nU(voice=rms): one\n"
                    "R: You said won.\nexpect first-sound < 30s\n"
                    "U: two\nR: You said two.\n"),
            "passed");
}

TEST_F(SpokenLinesTest, a_turn_may_take_too_long) {
  *hears = {"one"};
  EXPECT_THAT(failure("U(voice=rms): one\nR: You said one.\n"
                      "expect first-sound < 10ms\n"),
              testing::ContainsRegex("3: [0-9]+ ms"));
}

TEST_F(SpokenLinesTest, who_cuts_in_breaks_the_robot_off) {
  *hears = {"one", "two"};
  const auto result = hold("U(voice=rms): one\nR: You said one.\n"
                           "B(voice=rms): [You] two\nR: You said two.\n");
  EXPECT_FALSE(result.failure);
  EXPECT_THAT(result.trace,
              testing::Contains(HasSubstr("broken off: You said one.")));
}

TEST_F(SpokenLinesTest, who_goes_on_speaking_has_one_turn) {
  *hears = {"one two"};
  EXPECT_EQ(failure("P(voice=rms): one\nU(voice=rms): two\n"
                    "R: You said one two.\n"),
            "passed");
}

TEST_F(SpokenLinesTest, what_cannot_be_spoken_is_a_finding) {
  SpokenLines lines(spoken, suite("U(noise=thunder@3): one\n"),
                    std::make_shared<test::HummingVoices>());
  ASSERT_THAT(lines.findings(), SizeIs(1));
  EXPECT_THAT(script::to_string(lines.findings()[0]),
              HasSubstr("pink, white or babble"));
}

TEST_F(SpokenLinesTest, it_is_known_whether_something_is_spoken) {
  EXPECT_FALSE(is_spoken(suite("U: one\n")));
  EXPECT_TRUE(is_spoken(suite("U: one\nU(): one\n")));
}

} // namespace
} // namespace parlour::tools
