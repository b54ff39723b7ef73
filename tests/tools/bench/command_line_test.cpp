#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tools/bench/command_line.hpp"
#include "tools/parlour/console/exit_code.hpp"

namespace parlour::tools {
namespace {

using testing::HasSubstr;

struct BenchCommandLine : testing::Test {
  int call(std::vector<std::string> arguments) {
    return run_bench_command_line(std::move(arguments), process_places(),
                                  {out, err});
  }

  std::ostringstream out;
  std::ostringstream err;
};

TEST_F(BenchCommandLine, prints_a_table) {
  EXPECT_EQ(call({"script", "--runs", "1", "--only", "suspended"}),
            exit_code::success);
  EXPECT_THAT(out.str(), HasSubstr("CPU time of one operation"));
}

TEST_F(BenchCommandLine, measures_the_dialogue_engine) {
  EXPECT_EQ(call({"dialogue", "--runs", "1", "--only", "events"}),
            exit_code::success);
  EXPECT_THAT(out.str(), HasSubstr("an event, guarded"));
}

TEST_F(BenchCommandLine, measures_many_conversations) {
  EXPECT_EQ(call({"platform", "--sessions", "10", "--only", "open"}),
            exit_code::success)
      << err.str();
  EXPECT_THAT(out.str(), HasSubstr("KiB for each of 10"));
}

TEST_F(BenchCommandLine, knows_its_benches) {
  EXPECT_EQ(call({"floor"}), exit_code::usage);
  EXPECT_THAT(err.str(), HasSubstr("floor not in {nlu,platform,speech,"));
  EXPECT_EQ(call({}), exit_code::usage);
}

TEST_F(BenchCommandLine, says_which_rows_a_bench_has) {
  EXPECT_EQ(call({"script", "--only", "walls"}), exit_code::usage);
  EXPECT_THAT(err.str(), HasSubstr("bench script has no row 'walls'; it has "));
  EXPECT_EQ(call({"nlu", "--only", "turns"}), exit_code::usage);
  EXPECT_THAT(err.str(), HasSubstr("bench nlu has no row 'turns'; it has "));
}

TEST_F(BenchCommandLine, takes_whole_numbers_of_runs) {
  EXPECT_EQ(call({"script", "--runs", "0"}), exit_code::usage);
  EXPECT_THAT(err.str(), HasSubstr("'0' is no whole number from 1"));
}

} // namespace
} // namespace parlour::tools
