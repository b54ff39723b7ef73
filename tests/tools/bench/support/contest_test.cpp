#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tools/bench/support/contest.hpp"

namespace parlour::tools {
namespace {

using testing::HasSubstr;

const LuaPeer absent{"Lua 9", "bench_lua9", "", "liblua9-dev"};

TEST(Contest, a_smaller_ratio_is_a_better_one) {
  EXPECT_EQ(verdict(0.5, 0.5), "0.50, bar 0.50: met");
  EXPECT_EQ(verdict(0.51, 0.5), "0.51, bar 0.50: missed");
}

TEST(Contest, what_cannot_run_is_told) {
  Series series;
  series.add(Measured{12, "x"});
  EXPECT_EQ(series.result, "x");
  series.add(fail(ErrorKind::file, "no such file"));
  EXPECT_EQ(series.trouble, "no such file");
  EXPECT_EQ(series.figures.size(), 1u);
}

TEST(Contest, a_peer_that_is_not_built_says_how_to_build_it) {
  std::ostringstream out;
  EXPECT_TRUE(compare({}, {}, absent, 0, out));
  EXPECT_THAT(out.str(), HasSubstr("bench_lua9 is not built: "
                                   "tools/dependencies bench (liblua9-dev), "
                                   "then tools/bench/run"));
}

} // namespace
} // namespace parlour::tools
