#include "tests/tools/parlour/application_fixture.hpp"
#include "tools/parlour/conversation_test/conversation_runner.hpp"

namespace parlour::tools {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

class ConversationRunnerTest : public ApplicationTest {
protected:
  ConversationResult hold(const std::string& text) {
    const auto parsed = parse_conversation(text, "x.txt");
    EXPECT_TRUE(parsed.errors.empty());
    return hold_conversation(greeter_, parsed.conversation, coverage_);
  }
  // The line at which it failed, and what was found there.
  std::string found(const std::string& text) {
    const auto result = hold(text);
    return result.failure ? std::to_string(result.failure->line) + ": " +
                                result.failure->found
                          : "passed";
  }

  Application greeter_ = load("greeter");
  Coverage coverage_{*greeter_.program};
};

TEST_F(ConversationRunnerTest, holds_a_conversation) {
  const auto result = hold("R: Hello.\nU: one\nU: two\nR: You said one.\n"
                           "R~ .*two\\.\n");
  EXPECT_FALSE(result.failure);
  EXPECT_THAT(result.said, ElementsAre("R: Hello.", "U: one", "U: two",
                                       "R: You said one.", "R: You said two."));
  EXPECT_THAT(result.trace, Contains(HasSubstr("RecognitionResult")));
  EXPECT_TRUE(coverage_.parts()[0].missing.empty());
}

TEST_F(ConversationRunnerTest, lets_time_pass_at_an_answer_and_by_command) {
  EXPECT_EQ(found("R: Hello.\nU: later\nR: Now.\n"), "passed");
  EXPECT_EQ(found("R: Hello.\nU: later\nwait 3s\nU: one\nR: Now.\n"),
            "4: R: Now.");
  EXPECT_EQ(found("R: Hello.\nU: later\nwait 2999ms\nU: one\n"
                  "R: You said one.\nR: Now.\n"),
            "passed");
  EXPECT_EQ(found("clock 2026-01-01 09:00\nR: Hello.\n"
                  "clock 2026-01-01 08:00\n"),
            "3: it is already 2026-01-01 09:00:00");
}

TEST_F(ConversationRunnerTest, fails_at_the_first_line_that_differs) {
  EXPECT_EQ(found("R: Hi.\nU: one\nR: nothing\n"), "1: R: Hello.");
  EXPECT_EQ(found("R: Hello.\nR: More.\n"), "2: nothing was said within 60 s");
  EXPECT_EQ(found("U: one\nR: You said one.\n"), "1: R: Hello.");
  EXPECT_EQ(found("R: Hello.\nU: one\n"), "2: R: You said one.");
}

TEST_F(ConversationRunnerTest, says_what_it_found_instead) {
  const std::string begun = "R: Hello.\nU: call\n";
  EXPECT_EQ(found(begun + "expect post Telephone Call 64781001 Ada\n"),
            "passed");
  EXPECT_THAT(found(begun + "expect post Telephone Call 1\n"),
              HasSubstr("posted since the last U: "));
  EXPECT_EQ(found("R: Hello.\nexpect post Telephone Call\n"),
            "2: nothing was posted since the last U");
  EXPECT_EQ(found("R: Hello.\nexpect sql select name from guest = Bob\n"),
            "2: Ada");
  EXPECT_EQ(found("R: Hello.\nexpect sql select name from guest where 0 = 1\n"),
            "2: no row");
  EXPECT_THAT(found("R: Hello.\nexpect sql select x from y = 1\n"),
              HasSubstr("no such table"));
}

TEST_F(ConversationRunnerTest, begins_anew_each_time) {
  const std::string text =
      "R: Hello.\nexpect sql select count(*) from guest = 1\n";
  EXPECT_EQ(found(text), "passed");
  EXPECT_EQ(found(text), "passed");
}

TEST_F(ConversationRunnerTest, injects_events_into_an_open_session_only) {
  EXPECT_EQ(found("R: Hello.\nevent ASR RecognitionResult one 1\n"
                  "R: You said one.\n"),
            "passed");
  EXPECT_EQ(found("R: Hello.\nU: bye\nR: Goodbye.\n"
                  "event ASR RecognitionResult one\n"),
            "4: no session is open");
}

TEST_F(ConversationRunnerTest, accepts_other_words_where_it_may) {
  const auto parsed =
      parse_conversation("R: Hi.\nU: one\nR: two\nR~ x\n", "x.txt");
  const auto result =
      hold_conversation(greeter_, parsed.conversation, coverage_, {Words::any});
  EXPECT_THAT(result.rewordings,
              ElementsAre(Rewording{1, "Hi.", "Hello."},
                          Rewording{3, "two", "You said one."}));
  ASSERT_TRUE(result.failure);
  EXPECT_EQ(result.failure->line, 4u);
}

TEST_F(ConversationRunnerTest, tells_what_the_engine_thought) {
  const auto result = hold("R: Hello.\nU: one\nR: two\n");
  EXPECT_THAT(result.context, Contains("state       Welcome"));
}

} // namespace
} // namespace parlour::tools
