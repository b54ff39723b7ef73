// What the command lists and tries is in
// tests/tools/parlour/voice/devices_test.py.
#include <cstdlib>

#include "tests/support/temporary_folder.hpp"
#include "tests/tools/parlour/command_fixture.hpp"

namespace parlour::tools {
namespace {

using testing::HasSubstr;

TEST_F(CommandTest,
       devices_says_that_there_are_none_and_what_else_can_be_done) {
  const test::TemporaryFolder folder;
  folder.write("asound.conf", "");
  setenv("ALSA_CONFIG_PATH", (folder.path() / "asound.conf").c_str(), 1);
  EXPECT_EQ(call({"devices"}), exit_code::wrong);
  EXPECT_THAT(err_.str(), HasSubstr("--microphone FILE.wav"));
  EXPECT_EQ(call({"devices", "--test", "--seconds", "1"}), exit_code::wrong);
  EXPECT_THAT(err_.str(), HasSubstr("cannot be used"));
}

} // namespace
} // namespace parlour::tools
