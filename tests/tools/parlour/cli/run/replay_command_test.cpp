// Whole runs and their replays are in
// tests/tools/parlour/journal/replay_test.py.
#include "adapters/journal/journal_format.hpp"
#include "script/dialogue/inputs/session_record.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/tools/parlour/command_fixture.hpp"

namespace parlour::tools {
namespace {

using testing::HasSubstr;

class ReplayCommandTest : public CommandTest {
protected:
  const test::TemporaryFolder folder;

  int replay(const std::string& journal) {
    folder.write("000001.journal", journal);
    return call({"replay", "greeter", folder.path().string()});
  }
};

TEST_F(ReplayCommandTest, says_that_there_is_no_session) {
  EXPECT_EQ(replay(adapters::part_header(1)), exit_code::wrong);
  EXPECT_THAT(err_.str(), HasSubstr("has no session"));
}

TEST_F(ReplayCommandTest, says_that_a_session_is_of_another_program) {
  EXPECT_EQ(replay(adapters::part_header(1) +
                   adapters::framed(dialogue::to_bytes(
                       {"s1", dialogue::SessionOpened{7, 1, false}}))),
            exit_code::wrong);
  EXPECT_THAT(err_.str(), HasSubstr("its scripts have changed since"));
}

TEST_F(ReplayCommandTest, warns_of_a_record_that_is_cut_off) {
  EXPECT_EQ(replay(adapters::part_header(1) + "\5"), exit_code::wrong);
  EXPECT_THAT(err_.str(), HasSubstr("its 1 bytes are left out"));
}

TEST_F(ReplayCommandTest, says_what_is_no_journal) {
  EXPECT_EQ(replay("a letter"), exit_code::wrong);
  EXPECT_THAT(err_.str(), HasSubstr("no part of a journal"));
  EXPECT_EQ(call({"replay", "greeter", "/nowhere"}), exit_code::usage);
}

} // namespace
} // namespace parlour::tools
