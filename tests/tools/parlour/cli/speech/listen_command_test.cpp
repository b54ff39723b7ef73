// What is heard is in tests/tools/parlour/voice/speech_commands_test.py.
#include "tests/tools/parlour/command_fixture.hpp"

namespace parlour::tools {
namespace {

using testing::HasSubstr;

TEST_F(CommandTest, listen_needs_an_application_and_files) {
  EXPECT_EQ(call({"listen", "nobody", "x.wav"}), exit_code::usage);
  EXPECT_THAT(err_.str(), HasSubstr("there is no application 'nobody'"));
  EXPECT_EQ(call({"listen", application("greeter")}), exit_code::usage);
  EXPECT_THAT(err_.str(), HasSubstr("FILE is required"));
}

} // namespace
} // namespace parlour::tools
