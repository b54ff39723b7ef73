#include <gmock/gmock.h>

#include "tools/parlour/journal/session_lines.hpp"

namespace parlour::tools {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class SessionLinesTest : public testing::Test {
protected:
  dialogue::SessionHistory history;
  Message door;

  SessionLinesTest() {
    history.id = "s1";
    history.opened.seed = 7;
    door.source = "Door";
    door.command = "Opened";
    door.params = {"the left one", 2};
  }
};

TEST_F(SessionLinesTest, ATranscriptHasWhatWasSaid) {
  SessionLines lines(LineForm::transcript);
  EXPECT_THAT(lines.heading(history, 0), ElementsAre("session s1, 0 inputs"));
  EXPECT_THAT(lines.user({1, 0}, "two\nlines"), ElementsAre("U: two lines"));
  EXPECT_THAT(lines.robot({2, 9'000}, "Yes."), ElementsAre("R: Yes."));
  EXPECT_THAT(lines.event({3, 9'000}, door), IsEmpty());
  EXPECT_THAT(lines.other({4, 9'000}, "timer"), IsEmpty());
  EXPECT_EQ(lines.hidden({1, 0}), "U: ***");
  history.before = 3;
  EXPECT_EQ(lines.heading(history, 0).size(), 2u);
}

TEST_F(SessionLinesTest, ATestWaitsAsTheUserDid) {
  SessionLines lines(LineForm::test);
  EXPECT_THAT(lines.heading(history, 1'795'251'600'000),
              ElementsAre("# Session s1.", HasSubstr("clock 20"), "seed 7"));
  EXPECT_THAT(lines.robot({1, 1'000}, "Hello."), ElementsAre("R: Hello."));
  EXPECT_THAT(lines.user({2, 1'200}, "hi"), ElementsAre("U: hi"));
  EXPECT_THAT(lines.user({3, 4'200}, "you"),
              ElementsAre("wait 3000ms", "U: you"));
  EXPECT_THAT(lines.event({4, 4'200}, door),
              ElementsAre("event Door Opened \"the left one\" 2"));
}

// A scanner's text of digits is no number when the test is run.
TEST_F(SessionLinesTest, ATestHasTheValuesOfTheSession) {
  SessionLines lines(LineForm::test);
  EXPECT_THAT(lines.heading(history, 1'795'251'607'000)[1], HasSubstr(":07"));
  door.params = {"4006381", "true", Value(), List{1, "a"}};
  EXPECT_THAT(
      lines.event({1, 0}, door),
      ElementsAre("# Of the next line, 'unknown' was [1, a]",
                  R"(event Door Opened "4006381" "true" unknown unknown)"));
}

TEST_F(SessionLinesTest, JsonHasEachInput) {
  SessionLines lines(LineForm::json);
  EXPECT_THAT(lines.heading(history, 0), IsEmpty());
  EXPECT_THAT(
      lines.user({1, 2'007}, "\"hi\""),
      ElementsAre(HasSubstr(R"(:02.007","kind":"message","user":"\"hi\""})")));
  EXPECT_THAT(lines.robot({1, 0}, "Yes."),
              ElementsAre(HasSubstr(R"("kind":"output","robot":"Yes."})")));
  EXPECT_THAT(lines.other({9, 0}, "timer"),
              ElementsAre(testing::AllOf(HasSubstr(R"("input":9)"),
                                         HasSubstr(R"("kind":"timer"})"))));
  EXPECT_THAT(lines.event({3, 0}, door),
              ElementsAre(HasSubstr("Door.Opened(")));
  EXPECT_THAT(lines.hidden({1, 0}), HasSubstr(R"("user":"***"})"));
}

} // namespace
} // namespace parlour::tools
