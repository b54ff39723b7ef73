#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tools/bench/agents/connected_agents.hpp"

namespace parlour::tools {
namespace {

using testing::AllOf;
using testing::HasSubstr;

TEST(ConnectedAgents, all_are_there_by_both_transports) {
  std::ostringstream out;
  EXPECT_TRUE(connected_row({1, "connected", 20, 1}, out)) << out.str();
  EXPECT_THAT(out.str(), AllOf(HasSubstr("by lines: 20 of 20 agents"),
                               HasSubstr("by zeromq: 20 of 20 agents"),
                               HasSubstr("200 of 200 messages")));
}

} // namespace
} // namespace parlour::tools
