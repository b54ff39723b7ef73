#include <gtest/gtest.h>

#include "actors/support/instance_scope.hpp"

namespace parlour::actors {
namespace {

TEST(InstanceScope, SpeaksForTheSessionThatIsThere) {
  InstanceScope seat("desk", "desk");
  EXPECT_EQ(seat.session(), "desk");
  seat.begins("a");
  EXPECT_EQ(seat.session(), "a");
  seat.begins("b");
  seat.is_over("a"); // late
  EXPECT_EQ(seat.session(), "b");
  seat.is_over("b");
  EXPECT_EQ(seat.session(), "desk");
  EXPECT_EQ(InstanceScope().session(), "");
}

} // namespace
} // namespace parlour::actors
