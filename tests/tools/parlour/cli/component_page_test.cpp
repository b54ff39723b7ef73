#include "tests/tools/parlour/command_fixture.hpp"
#include "tools/parlour/cli/component_page.hpp"

namespace parlour::tools {
namespace {

using testing::AllOf;
using testing::HasSubstr;

TEST_F(CommandTest, help_prints_the_page_of_components) {
  EXPECT_EQ(call({"help", "--page", component_page_name}), exit_code::success);
  EXPECT_EQ(out_.str(), component_page());
  EXPECT_THAT(
      out_.str(),
      AllOf(HasSubstr("\n## FileMicrophone\n\nhears a sound file\n"),
            HasSubstr("* role: Microphone\n"),
            HasSubstr("| option | `silence` | duration, else 2s; how much"),
            HasSubstr("| fires | `FileEnded(position)` |")));
}

} // namespace
} // namespace parlour::tools
