#include <gtest/gtest.h>

#include "runtime/base/settings.hpp"

namespace parlour {
namespace {

TEST(Settings, FindASeatByItsName) {
  const std::vector<SeatSettings> seats = {{"desk"}, {"lobby"}};
  ASSERT_TRUE(find_seat(seats, "lobby"));
  EXPECT_EQ(find_seat(seats, "lobby")->name, "lobby");
  EXPECT_FALSE(find_seat(seats, "seat-1"));
}

} // namespace
} // namespace parlour
