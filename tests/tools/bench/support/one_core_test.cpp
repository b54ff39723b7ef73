#include <thread>

#include <gtest/gtest.h>

#include "tools/bench/support/one_core.hpp"

namespace parlour::tools {
namespace {

int cores() {
  cpu_set_t set;
  CPU_ZERO(&set);
  EXPECT_EQ(sched_getaffinity(0, sizeof set, &set), 0);
  return CPU_COUNT(&set);
}

TEST(OneCore, keeps_this_thread_and_new_ones_on_one_core) {
  const int before = cores();
  {
    const OneCore core;
    EXPECT_EQ(cores(), 1);
    std::thread([] { EXPECT_EQ(cores(), 1); }).join();
  }
  EXPECT_EQ(cores(), before);
}

} // namespace
} // namespace parlour::tools
