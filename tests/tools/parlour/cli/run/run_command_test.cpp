#include <cstdio>

#include <sys/wait.h>

#include "tests/support/paths.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/tools/parlour/command_fixture.hpp"
#include "tools/parlour/application/data_folder.hpp"

namespace parlour::tools {
namespace {

using testing::HasSubstr;

// A run with pipes needs a process of its own, because it reads standard input.
std::string piped(const std::string& input, const std::string& arguments,
                  const std::string& errors = "2>/dev/null") {
  const auto command = "printf '" + input + "' | " + test::program_path() +
                       " run " + arguments + " " + errors;
  auto* pipe = popen(command.c_str(), "r");
  std::string all;
  char buffer[4096];
  while (const auto size = fread(buffer, 1, sizeof buffer, pipe))
    all.append(buffer, size);
  return all + std::to_string(WEXITSTATUS(pclose(pipe)));
}

TEST_F(CommandTest, run_talks_by_pipe_in_virtual_time) {
  test::TemporaryFolder folder;
  const auto arguments = application("greeter") + " --data " +
                         folder.path().string() + " --clock '2026-11-21 09:00'";
  EXPECT_EQ(piped("one\\nlater\\n\\n\\ntwo\\nbye\\n", arguments),
            "Hello.\nYou said one.\nNow.\nYou said two.\nGoodbye.\n0");
  EXPECT_TRUE(folder.has("greeter.db"));
  EXPECT_EQ(piped("bye\\n\\nagain", arguments),
            "Hello.\nGoodbye.\nHello.\nYou said again.\n0");
  EXPECT_EQ(piped("", arguments), "Hello.\n0");
}

TEST_F(CommandTest, run_makes_the_database_anew_where_that_is_wanted) {
  test::TemporaryFolder folder;
  const auto arguments = application("greeter") + " --data " +
                         folder.path().string() + " --clock '2026-11-21 09:00'";
  piped("", arguments);
  folder.write("greeter.db.made-from", "another");
  EXPECT_THAT(piped("", arguments, "2>&1"), HasSubstr("schema or seed have"));
  EXPECT_THAT(piped("", arguments + " --fresh", "2>&1"),
              testing::Not(HasSubstr("schema or seed have")));
  EXPECT_TRUE(folder.has("greeter.db.before"));
  EXPECT_EQ(piped("", arguments, "2>&1"), "Hello.\n0");
}

TEST_F(CommandTest, run_tells_a_script_s_error_and_goes_on) {
  test::TemporaryFolder folder;
  folder.write("settings.xml", "<settings name=\"own\" start=\"Welcome\">"
                               "<Scripts><Script>own.xml</Script></Scripts>"
                               "</settings>");
  folder.write("own.xml", "<dialogue><state name=\"Welcome\"><Entrance>\n"
                          "<speak param=\"{1 / 0}\"/>\n"
                          "</Entrance></state></dialogue>");
  const auto arguments =
      folder.path().string() + " --data " + (folder.path() / "data").string();
  EXPECT_EQ(piped("", arguments),
            "I am sorry, I cannot do that at the moment.\n0");
  EXPECT_THAT(piped("", arguments, "2>&1"), HasSubstr("own.xml:2"));
}

TEST_F(CommandTest, run_shows_what_a_script_logs) {
  test::TemporaryFolder folder;
  folder.write("settings.xml", "<settings name=\"own\" start=\"Welcome\">"
                               "<Scripts><Script>own.xml</Script></Scripts>"
                               "</settings>");
  folder.write("own.xml", "<dialogue><state name=\"Welcome\"><Entrance>"
                          "<log param=\"low\" level=\"warning\"/>"
                          "<log param=\"here\"/>"
                          "</Entrance></state></dialogue>");
  const auto arguments =
      folder.path().string() + " --data " + (folder.path() / "data").string();
  EXPECT_THAT(piped("", arguments, "2>&1"),
              testing::MatchesRegex(
                  "log         warning: low  \\(session [0-9a-f]+\\)\n"
                  "log         info: here  \\(session [0-9a-f]+\\)\n0"));
}

TEST_F(CommandTest, run_starts_nothing_of_a_broken_application) {
  test::TemporaryFolder folder;
  const auto data = folder.path() / "data";
  EXPECT_EQ(call({"run", "broken", "--data", data.string()}), exit_code::wrong);
  EXPECT_THAT(err_.str(), HasSubstr("broken is not started: 6 errors"));
  EXPECT_FALSE(folder.has("data"));
}

TEST_F(CommandTest, run_refuses_a_damaged_database) {
  test::TemporaryFolder folder;
  folder.write("greeter.db", "this is no database at all");
  EXPECT_EQ(
      call({"run", "greeter", "--text", "--data", folder.path().string()}),
      exit_code::wrong);
  EXPECT_EQ(out_.str(), "");
  EXPECT_THAT(err_.str(), HasSubstr("greeter.db"));
}

TEST_F(CommandTest, run_refuses_a_folder_in_use) {
  test::TemporaryFolder folder;
  const auto held = DataFolder::open(folder.path());
  ASSERT_TRUE(held);
  EXPECT_EQ(call({"run", "greeter", "--data", folder.path().string()}),
            exit_code::wrong);
  EXPECT_THAT(err_.str(), HasSubstr("in use by another parlour"));
}

TEST_F(CommandTest, run_takes_a_microphone_only_with_a_voice) {
  EXPECT_EQ(call({"run", "greeter", "--microphone", "heard.wav"}),
            exit_code::usage);
  EXPECT_THAT(err_.str(), HasSubstr("--voice"));
}

} // namespace
} // namespace parlour::tools
