#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tools/bench/script/script_bench.hpp"

namespace parlour::tools {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

TEST(ScriptBench, a_row_tells_its_figure_and_its_bar) {
  std::ostringstream out;
  EXPECT_TRUE(script_bench({1, "suspended"}, out));
  EXPECT_THAT(out.str(), HasSubstr("bytes of an activation"));
  EXPECT_THAT(out.str(), HasSubstr("bar 200"));
  EXPECT_THAT(out.str(), Not(HasSubstr("fib")));
}

TEST(ScriptBench, the_script_that_it_loads_is_well_formed) {
  std::ostringstream out;
  EXPECT_TRUE(script_bench({1, "load"}, out));
  EXPECT_THAT(out.str(), HasSubstr("a script of 100 KB"));
}

TEST(ScriptBench, has_rows) {
  EXPECT_THAT(script_bench_rows(), Contains("calls"));
  EXPECT_THAT(script_bench_rows(), Contains("load"));
}

} // namespace
} // namespace parlour::tools
