#include <memory>
#include <thread>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "actors/support/shared_by_threads.hpp"

namespace parlour::actors {
namespace {

TEST(SharedByThreads, ShowsTheLastOneToEveryThread) {
  SharedByThreads<int> shared;
  EXPECT_EQ(shared.load(), nullptr);
  shared.store(std::make_shared<const int>(1));
  const auto last = std::make_shared<const int>(2);
  shared.store(last);
  std::vector<std::thread> threads;
  for (int i = 0; i < 40; ++i) // more than there are places
    threads.emplace_back([&] { EXPECT_EQ(shared.load().get(), last.get()); });
  for (auto& thread : threads)
    thread.join();
  shared.store(nullptr);
  EXPECT_EQ(shared.load(), nullptr);
}

TEST(SharedByThreads, ShowsEachThreadOneAfterTheOtherWhileTheyAreStored) {
  SharedByThreads<int> shared;
  shared.store(std::make_shared<const int>(0));
  constexpr int last = 1000;
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i)
    threads.emplace_back([&] {
      for (int seen = 0; seen < last;) {
        const auto now = *shared.load();
        ASSERT_GE(now, seen);
        seen = now;
      }
    });
  for (int i = 1; i <= last; ++i)
    shared.store(std::make_shared<const int>(i));
  for (auto& thread : threads)
    thread.join();
}

TEST(SharedByThreads, KeepsOneForWhoUsesItAndNoLonger) {
  SharedByThreads<int> shared;
  auto next = std::make_shared<const int>(1);
  const std::weak_ptr first = next;
  shared.store(std::exchange(next, std::make_shared<const int>(2)));
  auto used = shared.load();
  shared.store(next);
  EXPECT_FALSE(first.expired());
  used.reset();
  EXPECT_TRUE(first.expired());
}

} // namespace
} // namespace parlour::actors
