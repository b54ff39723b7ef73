#include <gtest/gtest.h>

#include "actors/support/place.hpp"

namespace parlour::actors {
namespace {

TEST(Place, SpeaksForTheSessionThatIsThere) {
  Place seat("desk", "desk");
  EXPECT_EQ(seat.session(), "desk");
  seat.begins("a");
  EXPECT_EQ(seat.session(), "a");
  seat.begins("b");
  seat.is_over("a"); // late
  EXPECT_EQ(seat.session(), "b");
  seat.is_over("b");
  EXPECT_EQ(seat.session(), "desk");
  EXPECT_EQ(Place().session(), "");
}

} // namespace
} // namespace parlour::actors
