#include "tests/tools/parlour/command_fixture.hpp"
#include "tools/parlour/reference/pages.hpp"

namespace parlour::tools {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

TEST_F(CommandTest, help_prints_pages) {
  for (const auto& page : reference_pages()) {
    EXPECT_EQ(call({"help", "--page", page}), exit_code::success);
    EXPECT_THAT(out_.str(), StartsWith("# "));
  }
  EXPECT_EQ(call({"help", "--page", "elements"}), exit_code::success);
  EXPECT_THAT(out_.str(), AllOf(HasSubstr("\n## `<speak>`\n\nsay it\n"),
                                HasSubstr("| `interrupt` | true or false |"),
                                HasSubstr("```xml\n<speak param=")));
}

} // namespace
} // namespace parlour::tools
