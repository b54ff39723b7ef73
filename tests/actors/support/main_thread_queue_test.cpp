#include <thread>

#include <gtest/gtest.h>

#include "actors/support/main_thread_queue.hpp"

namespace parlour::actors {
namespace {

void from_another_thread(MainThreadQueue& queue, int& calls) {
  std::thread([&] {
    const bool waits = queue.defers();
    const auto before = calls;
    queue.post([&] { ++calls; });
    EXPECT_EQ(waits, calls == before);
  }).join();
}

TEST(MainThreadQueue, RunsAtOnceWhenOpen) {
  MainThreadQueue queue(MainThreadQueue::Kind::open);
  int calls = 0;
  from_another_thread(queue, calls);
  EXPECT_EQ(calls, 1);
  EXPECT_FALSE(queue.drain());
}

TEST(MainThreadQueue, KeepsOtherThreadsWaiting) {
  MainThreadQueue queue(MainThreadQueue::Kind::one_thread);
  int calls = 0;
  from_another_thread(queue, calls);
  EXPECT_EQ(calls, 0);
  EXPECT_FALSE(queue.defers());
  queue.post([&] { ++calls; });
  EXPECT_EQ(calls, 1);
  EXPECT_TRUE(queue.drain());
  EXPECT_EQ(calls, 2);
  EXPECT_FALSE(queue.drain());
}

} // namespace
} // namespace parlour::actors
