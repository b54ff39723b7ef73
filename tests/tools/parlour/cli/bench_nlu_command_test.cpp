#include "tests/support/paths.hpp"
#include "tests/tools/parlour/command_fixture.hpp"

namespace parlour::tools {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST_F(CommandTest, bench_nlu_knows_its_rows) {
  EXPECT_EQ(call({"bench", "nlu", "--only", "turns"}), exit_code::usage);
}

TEST_F(CommandTest, bench_nlu_measures_the_receptionist) {
  places_.working = test::source_path("");
  EXPECT_EQ(call({"bench", "nlu", "--only", "application"}), exit_code::well)
      << err_.str();
  EXPECT_THAT(out_.str(), HasSubstr("% understood"));
  EXPECT_THAT(out_.str(), Not(HasSubstr("clinc")));
}

} // namespace
} // namespace parlour::tools
