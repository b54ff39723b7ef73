#include <gtest/gtest.h>

#include "runtime/base/call_deadline.hpp"

namespace parlour {
namespace {

using namespace std::chrono_literals;

TEST(CallDeadline, LeavesWhoAskedTheTimeToAskAnother) {
  ComponentPolicy policy;
  EXPECT_EQ(call_deadline(policy, defaults::request_timeout), 5s);
  EXPECT_EQ(call_deadline(policy, 3s), 1500ms);
  EXPECT_EQ(call_deadline(policy, 1h), defaults::component_deadline);
}

TEST(CallDeadline, IsWhatWasSaid) {
  ComponentPolicy policy;
  policy.deadline = 20s;
  EXPECT_EQ(call_deadline(policy, 3s), 20s);
  policy.deadline = defaults::component_deadline;
  EXPECT_EQ(call_deadline(policy, 3s), defaults::component_deadline);
}

} // namespace
} // namespace parlour
