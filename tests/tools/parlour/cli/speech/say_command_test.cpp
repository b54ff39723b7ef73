// How it sounds is in tests/tools/parlour/voice/speech_commands_test.py.
#include "tests/tools/parlour/command_fixture.hpp"

namespace parlour::tools {
namespace {

using testing::HasSubstr;

TEST_F(CommandTest, say_refuses_what_nobody_can_say) {
  EXPECT_EQ(call({"say", "  "}), exit_code::usage);
  EXPECT_THAT(err_.str(), HasSubstr("there is nothing to say"));
}

TEST_F(CommandTest, say_refuses_what_is_no_voice) {
  EXPECT_EQ(call({"say", "hello", "--component", "SphinxASR"}),
            exit_code::usage);
  EXPECT_THAT(err_.str(), HasSubstr("SphinxASR is no voice"));
  EXPECT_EQ(call({"say", "hello", "--component", "EspeakTT"}),
            exit_code::usage);
  EXPECT_THAT(err_.str(), HasSubstr("did you mean 'EspeakTTS'"));
  EXPECT_EQ(call({"say", "hello", "--option", "volume"}), exit_code::usage);
  EXPECT_THAT(err_.str(), HasSubstr("lacks its '=value'"));
}

} // namespace
} // namespace parlour::tools
