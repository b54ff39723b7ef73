#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tools/bench/components/component_bench.hpp"

namespace parlour::tools {
namespace {

using testing::HasSubstr;

TEST(ComponentBench, tells_its_figure_and_its_peers) {
  std::ostringstream out;
  EXPECT_TRUE(component_bench({1, ""}, out));
  EXPECT_THAT(out.str(), HasSubstr("median of 1 runs"));
  EXPECT_THAT(out.str(), HasSubstr("of their speed, bar 0.70"));
  EXPECT_EQ(component_bench_rows().size(), 1u);
}

} // namespace
} // namespace parlour::tools
