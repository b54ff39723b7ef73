// Journals of whole runs are in tests/tools/parlour/journal/replay_test.py.
#include "adapters/journal/journal_format.hpp"
#include "script/dialogue/inputs/session_record.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/tools/parlour/command_fixture.hpp"

namespace parlour::tools {
namespace {

using testing::HasSubstr;

class JournalCommandTest : public CommandTest {
protected:
  const test::TemporaryFolder folder;

  void write(const std::string& after = {}) {
    auto bytes = adapters::part_header(1);
    for (const auto& record :
         {dialogue::to_bytes({"s1", dialogue::SessionOpened{7, 1, true}}),
          dialogue::to_bytes({"s2", dialogue::SessionOpened{7, 1, false}}),
          dialogue::to_bytes({"s2", dialogue::SessionClosed{}})})
      bytes += adapters::framed(record);
    folder.write("000001.journal", bytes + after);
  }
  int journal(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "journal");
    arguments.push_back(folder.path().string());
    return call(arguments);
  }
};

TEST_F(JournalCommandTest, lists_the_sessions) {
  write();
  EXPECT_EQ(journal({"list"}), exit_code::success);
  EXPECT_THAT(out_.str(), HasSubstr("s1  open        0 inputs  program "
                                    "0000000000000007  strict\n"));
  EXPECT_THAT(out_.str(), HasSubstr("s2  ended"));
}

TEST_F(JournalCommandTest, verifies) {
  write();
  EXPECT_EQ(journal({"verify"}), exit_code::success);
  EXPECT_THAT(out_.str(), HasSubstr("2 sessions, 1 of them open"));
}

TEST_F(JournalCommandTest, tells_of_damage) {
  write(std::string(20, 'x'));
  EXPECT_EQ(journal({"verify"}), exit_code::wrong);
  EXPECT_THAT(err_.str(), HasSubstr("000001.journal: byte"));
  EXPECT_EQ(journal({"list"}), exit_code::wrong);
  EXPECT_THAT(out_.str(), HasSubstr("s1  damaged"));
}

TEST_F(JournalCommandTest, refuses_what_cannot_be_one_test) {
  write();
  EXPECT_EQ(journal({"export", "greeter"}), exit_code::usage);
  EXPECT_THAT(err_.str(), HasSubstr("name its session"));
  EXPECT_EQ(journal({"export", "greeter", "--as", "json"}), exit_code::wrong);
  EXPECT_THAT(err_.str(), HasSubstr("other scripts"));
}

TEST_F(JournalCommandTest, says_that_there_is_none) {
  EXPECT_EQ(journal({"list"}), exit_code::usage);
  EXPECT_EQ(journal({"verify"}), exit_code::usage);
}

} // namespace
} // namespace parlour::tools
