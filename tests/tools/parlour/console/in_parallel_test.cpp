#include <atomic>
#include <latch>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "tools/parlour/console/in_parallel.hpp"

namespace parlour::tools {
namespace {

TEST(InParallelTest, DoesEachOnce) {
  for (const unsigned threads : {0u, 1u, 3u, 100u}) {
    std::vector<std::atomic<int>> done(20);
    in_parallel(done.size(), threads, [&](std::size_t i) { ++done[i]; });
    for (const auto& times : done)
      EXPECT_EQ(times, 1) << threads;
  }
}

// Each waits for the other, so that it would never end on one thread.
TEST(InParallelTest, DoesSeveralAtATime) {
  std::latch both(2);
  std::atomic<int> done = 0;
  in_parallel(2, 2, [&](std::size_t) {
    both.arrive_and_wait();
    ++done;
  });
  EXPECT_EQ(done, 2);
}

TEST(InParallelTest, DoesItHereWhereThereIsOneThread) {
  const auto here = std::this_thread::get_id();
  in_parallel(
      3, 1, [&](std::size_t) { EXPECT_EQ(std::this_thread::get_id(), here); });
  in_parallel(0, 4, [](std::size_t) { ADD_FAILURE(); });
}

} // namespace
} // namespace parlour::tools
