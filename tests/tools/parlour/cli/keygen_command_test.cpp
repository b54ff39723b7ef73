#include <filesystem>

#include "tests/support/temporary_folder.hpp"
#include "tests/tools/parlour/command_fixture.hpp"

namespace parlour::tools {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::MatchesRegex;

class KeygenCommandTest : public CommandTest {
protected:
  KeygenCommandTest() {
    places_.working = folder_.path();
  }

  test::TemporaryFolder folder_;
};

TEST_F(KeygenCommandTest, keeps_the_secret_and_prints_the_public_key) {
  ASSERT_EQ(call({"keygen", "robot.key"}), exit_code::success) << err_.str();
  const auto secret = folder_.read("robot.key");
  ASSERT_EQ(secret.size(), 41u);
  EXPECT_EQ(fs::status(folder_.path() / "robot.key").permissions(),
            fs::perms::owner_read | fs::perms::owner_write);
  EXPECT_THAT(out_.str(),
              MatchesRegex("public key: .{40}\nsecret key: in "
                           "robot.key\n(.|\n)*<agent name=\"NAME\" key=\".*\"/>"
                           "</agents>\n"));
  EXPECT_THAT(out_.str(), testing::Not(HasSubstr(secret.substr(0, 40))));
}

TEST_F(KeygenCommandTest, overwrites_nothing) {
  folder_.write("robot.key", "precious");
  EXPECT_EQ(call({"keygen", "robot.key"}), exit_code::wrong);
  EXPECT_THAT(err_.str(), HasSubstr("is there already"));
  EXPECT_EQ(folder_.read("robot.key"), "precious");
  EXPECT_EQ(out_.str(), "");
}

TEST_F(KeygenCommandTest, says_that_it_cannot_write) {
  EXPECT_EQ(call({"keygen", "missing/robot.key"}), exit_code::wrong);
  EXPECT_THAT(err_.str(), HasSubstr("No such file or directory"));
  EXPECT_EQ(call({"keygen"}), exit_code::usage);
}

} // namespace
} // namespace parlour::tools
