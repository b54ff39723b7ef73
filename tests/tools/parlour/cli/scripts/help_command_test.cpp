#include "tests/tools/parlour/command_fixture.hpp"

namespace parlour::tools {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

TEST_F(CommandTest, help_tells_of_names_and_commands) {
  EXPECT_EQ(call({"help", "speak"}), exit_code::success);
  EXPECT_THAT(out_.str(), StartsWith("<speak>"));
  EXPECT_EQ(call({"run", "--help"}), exit_code::success);
  const auto of_run = out_.str();
  EXPECT_EQ(call({"help", "run"}), exit_code::success);
  EXPECT_EQ(out_.str(), of_run);
  EXPECT_EQ(call({"--help"}), exit_code::success);
  const auto of_all = out_.str();
  EXPECT_EQ(call({"help"}), exit_code::success);
  EXPECT_EQ(out_.str(), of_all);
  EXPECT_EQ(call({"help", "speek"}), exit_code::usage);
  EXPECT_THAT(err_.str(), HasSubstr("did you mean 'speak'?"));
  EXPECT_EQ(call({"help", "speak", "--page", "nothing"}), exit_code::usage);
}

TEST_F(CommandTest, help_of_a_function_names_the_command_of_its_name) {
  EXPECT_EQ(call({"help", "format"}), exit_code::success);
  EXPECT_THAT(out_.str(), AllOf(StartsWith("format(pattern"),
                                HasSubstr("`parlour format --help`")));
  EXPECT_EQ(call({"help", "component"}), exit_code::success);
  EXPECT_THAT(out_.str(), testing::Not(HasSubstr("--help")));
}

} // namespace
} // namespace parlour::tools
