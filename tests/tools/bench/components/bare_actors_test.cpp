#include <gtest/gtest.h>

#include "tools/bench/components/component_workload.hpp"

namespace parlour::tools {
namespace {

TEST(BareActors, do_the_same) {
  for (const auto way : {Way::hub, Way::direct}) {
    const auto played = bare_actors_play({200, 3}, way);
    EXPECT_EQ(played.result, components_play({200, 3})->result);
    EXPECT_GT(played.nanoseconds, 0);
  }
}

} // namespace
} // namespace parlour::tools
