#include <gtest/gtest.h>
#include <sys/resource.h>

#include "tools/parlour/serve/file_limit.hpp"

namespace parlour::tools {
namespace {

TEST(FileLimit, LeavesRoomForOthers) {
  rlimit limit{};
  getrlimit(RLIMIT_NOFILE, &limit);
  const std::size_t hard = limit.rlim_max;
  EXPECT_EQ(room_for_connections(1, 1), 1);
  EXPECT_EQ(room_for_connections(hard, 100), hard - 100);
  EXPECT_EQ(room_for_connections(hard, hard + 1), 0);
  getrlimit(RLIMIT_NOFILE, &limit);
  EXPECT_EQ(limit.rlim_cur, limit.rlim_max);
}

} // namespace
} // namespace parlour::tools
