#include "tests/support/temporary_folder.hpp"
#include "tests/tools/parlour/command_fixture.hpp"

namespace parlour::tools {
namespace {

using testing::HasSubstr;

TEST_F(CommandTest, test_holds_conversations_and_prints_coverage) {
  EXPECT_EQ(call({"test", "greeter"}), exit_code::success) << out_.str();
  EXPECT_THAT(out_.str(), testing::StartsWith("coverage:\n"));
  EXPECT_THAT(out_.str(), testing::EndsWith("\n1 of 1 conversations passed\n"));
  EXPECT_THAT(out_.str(), HasSubstr("states 1 of 1"));
  EXPECT_THAT(out_.str(), HasSubstr("handlers 1 of 1"));
}

// What people say to an application that has few examples.
TEST_F(CommandTest, test_holds_conversations_with_bicycles) {
  EXPECT_EQ(call({"test", "bicycles", "-q"}), exit_code::success) << out_.str();
}

// What forms need, from words to words.
TEST_F(CommandTest, test_holds_conversations_with_room_service) {
  EXPECT_EQ(call({"test", "room-service", "-q"}), exit_code::success)
      << out_.str();
}

TEST_F(CommandTest, test_shows_the_first_line_that_differs) {
  test::TemporaryFolder folder;
  folder.write("bad.txt", "R: Hello.\nU: one\nR: You said two.\n");
  const auto file = (folder.path() / "bad.txt").string();
  const auto report = (folder.path() / "report.xml").string();
  EXPECT_EQ(call({"test", "greeter", file, "--junit", report}),
            exit_code::wrong);
  EXPECT_THAT(out_.str(),
              HasSubstr("FAILED " + file +
                        ":3:\n    R: Hello.\n    U: one\n    R: You said "
                        "one.\n  expected: R: You said two.\n  found:    "
                        "R: You said one.\n"));
  EXPECT_THAT(folder.read("report.xml"), HasSubstr("failures=\"1\""));
}

TEST_F(CommandTest, test_names_files_from_the_working_folder) {
  test::TemporaryFolder folder;
  folder.write("dialogues/bad.txt", "R: Nothing.\n");
  const auto app = application("greeter");
  places_.working = folder.path();
  EXPECT_EQ(call({"test", app, "dialogues/bad.txt"}), exit_code::wrong);
  EXPECT_THAT(out_.str(), testing::StartsWith("FAILED dialogues/bad.txt:1:\n"));
  folder.write("dialogues/brief.txt", "R: Hello.\n");
  places_.working = app;
  EXPECT_EQ(call({"test", app, (folder.path() / "dialogues/brief.txt")}),
            exit_code::success);
  EXPECT_THAT(out_.str(), HasSubstr("    not reached: greeter.xml:"));
}

// If the folder was renamed, the test must fail.
TEST_F(CommandTest, test_fails_where_there_is_no_conversation) {
  test::TemporaryFolder folder;
  folder.write("settings.xml", "<settings name=\"own\" start=\"Welcome\">"
                               "<Scripts><Script>own.xml</Script></Scripts>"
                               "</settings>");
  folder.write("own.xml", "<dialogue><state name=\"Welcome\"/></dialogue>");
  folder.write("dialogs/hello.txt", "R: Hello.\n");
  EXPECT_EQ(call({"test", folder.path().string()}), exit_code::wrong);
  EXPECT_THAT(err_.str(), HasSubstr("has no conversations"));
}

TEST_F(CommandTest, test_is_brief_where_that_is_wanted) {
  EXPECT_EQ(call({"test", "greeter", "--quiet"}), exit_code::success);
  EXPECT_EQ(out_.str(), "1 of 1 conversations passed\n");
}

TEST_F(CommandTest, test_fails_for_what_is_left_over) {
  test::TemporaryFolder folder;
  folder.write("a.txt", "R: Hello.\nU: one\n");
  folder.write("b.txt", "U: one\n");
  EXPECT_EQ(call({"test", "greeter", (folder.path() / "a.txt").string()}),
            exit_code::wrong);
  EXPECT_EQ(call({"test", "greeter", (folder.path() / "b.txt").string()}),
            exit_code::wrong);
}

TEST_F(CommandTest, test_fails_for_each_expectation_that_does_not_hold) {
  test::TemporaryFolder folder;
  const auto file = (folder.path() / "x.txt").string();
  for (const auto* wrong :
       {"expect post Taxi Book", "expect post Telephone Call 1",
        "expect sql select name from guest = Bob",
        "expect sql select nothing from nowhere = 1", "R: Nothing."}) {
    folder.write("x.txt", std::string("R: Hello.\nU: call\n") + wrong + "\n");
    EXPECT_EQ(call({"test", "greeter", file}), exit_code::wrong) << wrong;
  }
}

TEST_F(CommandTest, test_reports_wrong_files_before_it_begins) {
  test::TemporaryFolder folder;
  folder.write("x.txt", "say hello\nexpect state Welcom\n");
  const auto file = (folder.path() / "x.txt").string();
  EXPECT_EQ(call({"test", "greeter", file}), exit_code::wrong);
  EXPECT_THAT(out_.str(), HasSubstr("x.txt:1:1: error: unknown directive"));
  EXPECT_THAT(out_.str(), HasSubstr("x.txt:2:1: error: there is no state "
                                    "'Welcom', did you mean 'Welcome'?"));
  EXPECT_EQ(call({"test", "greeter", "none"}), exit_code::usage);
}

TEST_F(CommandTest, test_tells_what_the_engine_thought_of_a_failure) {
  test::TemporaryFolder folder;
  folder.write("bad.txt", "R: Hello.\nU: one\nR: You said two.\n");
  const auto file = (folder.path() / "bad.txt").string();
  EXPECT_EQ(call({"test", "greeter", file}), exit_code::wrong);
  EXPECT_THAT(out_.str(),
              HasSubstr("  found:    R: You said one.\n"
                        "  what the engine thought:\n"
                        "    state       Welcome\n"
                        "    before      output      released: You said "
                        "one.\n"));
}

class UpdateTest : public CommandTest {
protected:
  // The file after `parlour test --update`.
  std::string update(const std::string& text, int status = exit_code::success) {
    folder_.write("x.txt", text);
    EXPECT_EQ(call({"test", "greeter", file_, "--update", "--quiet"}), status)
        << out_.str();
    return folder_.read("x.txt");
  }

  test::TemporaryFolder folder_;
  std::string file_ = (folder_.path() / "x.txt").string();
};

TEST_F(UpdateTest, writes_other_words_into_the_conversation) {
  EXPECT_EQ(update("# hello\nR:  Hi.\n\nU: one\nR: You said two.\n"),
            "# hello\nR:  Hello.\n\nU: one\nR: You said one.\n");
  EXPECT_EQ(out_.str(), "UPDATED " + file_ +
                            ":2:\n  - R: Hi.\n  + R: Hello.\n"
                            "UPDATED " +
                            file_ +
                            ":5:\n  - R: You said two.\n"
                            "  + R: You said one.\n"
                            "1 of 1 conversations passed\n");
  EXPECT_EQ(call({"test", "greeter", file_}), exit_code::success);
}

TEST_F(UpdateTest, leaves_alone_what_is_right) {
  const std::string right = "R: Hello.\nU: one\nR: You said one.";
  EXPECT_EQ(update(right), right);
  EXPECT_EQ(out_.str(), "1 of 1 conversations passed\n");
}

// More than the words is different, so --update changes nothing.
TEST_F(UpdateTest, changes_nothing_where_more_than_words_differs) {
  for (const std::string rest :
       {"U: one\n", "U: one\nR: You said one.\nR: More.\n",
        "U: call\nexpect post Taxi Book\n", "expect state Rest\n",
        "expect sql select name from guest = Bob\n", "U: one\nR~ Nothing\n"}) {
    const auto text = "R: Hi.\n" + rest;
    EXPECT_EQ(update(text, exit_code::wrong), text) << rest;
    EXPECT_THAT(out_.str(), testing::Not(HasSubstr("UPDATED")));
  }
}

} // namespace
} // namespace parlour::tools
