// What is played is in tests/tools/parlour/serve/serve_test.py.
#include "tests/support/temporary_folder.hpp"
#include "tests/tools/parlour/command_fixture.hpp"

namespace parlour::tools {
namespace {

using testing::HasSubstr;

class LoadCommandTest : public CommandTest {
protected:
  const test::TemporaryFolder folder;
  int load(const std::vector<std::string>& more) {
    std::vector<std::string> all{"load", folder.path().string()};
    all.insert(all.end(), more.begin(), more.end());
    return call(all);
  }
};

TEST_F(LoadCommandTest, says_what_is_wrong_with_its_options) {
  EXPECT_EQ(load({"--to", "nowhere"}), exit_code::usage);
  EXPECT_THAT(err_.str(), HasSubstr("'nowhere' is no HOST:PORT"));
  for (const auto* rate : {"0", "-1", "nan", "inf", "many"})
    EXPECT_EQ(load({"--rate", rate}), exit_code::usage) << rate;
  EXPECT_EQ(load({"--conversations", "none"}), exit_code::usage);
  EXPECT_THAT(err_.str(), HasSubstr("there is no conversation 'none'"));
}

TEST_F(LoadCommandTest, says_what_it_cannot_play) {
  folder.write("one.txt", "R: Hello.\nwait 3s\n");
  folder.write("two.txt", "clock 2026-11-21 18:00\nR: Hello.\n");
  EXPECT_EQ(load({}), exit_code::usage);
  EXPECT_THAT(err_.str(), HasSubstr("one.txt: line 2: it lets time pass"));
  EXPECT_THAT(err_.str(), HasSubstr("two.txt: it begins at another time"));
  EXPECT_THAT(err_.str(), HasSubstr("0 conversations are played, 2 are left"));
}

TEST_F(LoadCommandTest, says_what_is_no_conversation) {
  folder.write("one.txt", "X: Hello.\n");
  EXPECT_EQ(load({}), exit_code::wrong);
  EXPECT_THAT(err_.str(), HasSubstr("one.txt:1"));
}

} // namespace
} // namespace parlour::tools
