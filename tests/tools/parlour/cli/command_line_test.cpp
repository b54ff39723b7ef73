#include "script/lint/lints.hpp"
#include "tests/tools/parlour/command_fixture.hpp"

namespace parlour::tools {
namespace {

using testing::HasSubstr;

TEST_F(CommandTest, line_tells_wrong_usage) {
  EXPECT_EQ(call({}), exit_code::usage);
  EXPECT_EQ(call({"chek", "x"}), exit_code::usage);
  EXPECT_THAT(err_.str(), HasSubstr("there is no command 'chek', did you mean "
                                    "'check'?"));
  EXPECT_EQ(call({"run"}), exit_code::usage);
  EXPECT_EQ(call({"run", "greeter", "--clock", "noon"}), exit_code::usage);
  EXPECT_EQ(call({"check", "greeter", "--nothing"}), exit_code::usage);
}

TEST_F(CommandTest, line_has_help_version_and_completion) {
  EXPECT_EQ(call({"--version"}), exit_code::success);
  EXPECT_THAT(out_.str(), testing::StartsWith("parlour "));
  for (const auto* command :
       {"run", "check", "format", "schema", "test", "exec", "understand"}) {
    EXPECT_EQ(call({command, "--help"}), exit_code::success);
    EXPECT_THAT(out_.str(), HasSubstr("Usage: "));
  }
  EXPECT_EQ(call({"check", "--help"}), exit_code::success);
  for (const auto& lint : script::lint::lints()) {
    EXPECT_THAT(out_.str(), HasSubstr("  " + lint.name + " "));
    EXPECT_THAT(out_.str(), HasSubstr(lint.sentence));
  }
  EXPECT_EQ(call({"completion", "bash"}), exit_code::success);
  EXPECT_THAT(out_.str(),
              HasSubstr("'check') words=\"--help --plugins --json --fix"));
  EXPECT_THAT(
      out_.str(),
      HasSubstr("'run') words=\"--help --plugins --clock --text --fresh"));
}

} // namespace
} // namespace parlour::tools
