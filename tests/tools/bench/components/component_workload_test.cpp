#include <gtest/gtest.h>

#include "tools/bench/components/component_workload.hpp"

namespace parlour::tools {
namespace {

TEST(ComponentWorkload, throws_every_ball) {
  const auto played = components_play({200, 3});
  ASSERT_TRUE(played) << played.error().message;
  EXPECT_GT(played->nanoseconds, 0);
}

} // namespace
} // namespace parlour::tools
