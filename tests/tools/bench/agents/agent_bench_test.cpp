#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tools/bench/agents/agent_bench.hpp"

namespace parlour::tools {
namespace {

using testing::AllOf;
using testing::HasSubstr;

TEST(AgentBench, tells_its_figures_and_its_peers) {
  std::ostringstream out;
  EXPECT_TRUE(agent_bench({1, "lines"}, out)) << out.str();
  EXPECT_THAT(out.str(),
              AllOf(HasSubstr("median of 1 runs"), HasSubstr("bar 0.20"),
                    HasSubstr("bar 1.50"), HasSubstr("TCP:")));
  EXPECT_EQ(agent_bench_rows().size(), 4u);
}

} // namespace
} // namespace parlour::tools
