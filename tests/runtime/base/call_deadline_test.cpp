#include <gtest/gtest.h>

#include "runtime/base/call_deadline.hpp"

namespace parlour {
namespace {

using namespace std::chrono_literals;

TEST(CallDeadline, LeavesWhoAskedTheTimeToAskAnother) {
  Upkeep upkeep;
  EXPECT_EQ(call_deadline(upkeep, defaults::request_timeout), 5s);
  EXPECT_EQ(call_deadline(upkeep, 3s), 1500ms);
  EXPECT_EQ(call_deadline(upkeep, 1h), defaults::component_deadline);
}

TEST(CallDeadline, IsWhatWasSaid) {
  Upkeep upkeep;
  upkeep.deadline = 20s;
  EXPECT_EQ(call_deadline(upkeep, 3s), 20s);
}

} // namespace
} // namespace parlour
