#include "tests/tools/parlour/command_fixture.hpp"

namespace parlour::tools {
namespace {

using testing::HasSubstr;

TEST_F(CommandTest, bench_prints_a_table) {
  EXPECT_EQ(call({"bench", "script", "--runs", "1", "--only", "suspended"}),
            exit_code::well);
  EXPECT_THAT(out_.str(), HasSubstr("CPU time of one operation"));
}

TEST_F(CommandTest, bench_measures_the_dialogue_engine) {
  EXPECT_EQ(call({"bench", "dialogue", "--runs", "1", "--only", "events"}),
            exit_code::well);
  EXPECT_THAT(out_.str(), HasSubstr("an event, guarded"));
}

TEST_F(CommandTest, bench_knows_its_names) {
  EXPECT_EQ(call({"bench", "floor"}), exit_code::usage);
  EXPECT_EQ(call({"bench", "script", "--only", "walls"}), exit_code::usage);
  EXPECT_EQ(call({"bench", "script", "--only", "turns"}), exit_code::usage);
}

} // namespace
} // namespace parlour::tools
