#include <thread>

#include <gtest/gtest.h>

#include "actors/support/quiescence_tracker.hpp"

namespace parlour::actors {
namespace {

TEST(QuiescenceTracker, IsNoneWhenTheLastCopyIsGone) {
  QuiescenceTracker count;
  auto piece = count.begin();
  auto copy = piece;
  piece.reset();
  EXPECT_FALSE(count.none());
  copy.reset();
  EXPECT_TRUE(count.none());
}

TEST(QuiescenceTracker, WakesWhoWaitsForQuiet) {
  QuiescenceTracker count;
  auto piece = count.begin();
  std::thread worker([&] { piece.reset(); });
  EXPECT_TRUE(count.wait([&] { return count.none(); }));
  worker.join();
}

TEST(QuiescenceTracker, InterruptsWaits) {
  QuiescenceTracker count;
  auto piece = count.begin();
  std::thread other([&] { count.interrupt(); });
  EXPECT_FALSE(count.wait([&] { return count.none(); }));
  other.join();
  piece.reset();
  EXPECT_FALSE(count.wait([&] { return count.none(); }));
  count.forget_interrupt();
  EXPECT_TRUE(count.wait([&] { return count.none(); }));
}

TEST(QuiescenceTracker, EndsAWaitAtItsDeadline) {
  QuiescenceTracker count;
  auto never = [] { return false; };
  EXPECT_FALSE(count.wait(never, std::chrono::steady_clock::now()));
}

TEST(QuiescenceTracker, CountsSessionsThatWait) {
  QuiescenceTracker count;
  count.session_waits(true);
  EXPECT_TRUE(count.sessions_wait());
  count.session_waits(false);
  EXPECT_FALSE(count.sessions_wait());
}

} // namespace
} // namespace parlour::actors
