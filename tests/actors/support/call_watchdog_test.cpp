#include <gtest/gtest.h>

#include "actors/support/call_watchdog.hpp"
#include "actors/support/quiescence_tracker.hpp"

namespace parlour::actors {
namespace {

using namespace std::chrono_literals;
using Begin = CallWatchdog::Begin;

class CallWatchTest : public testing::Test {
protected:
  Begin begin(Timestamp now) {
    return watch.begin(now, work);
  }
  // Whether somebody still waits for the work.
  bool held() const {
    return !count.none();
  }

  QuiescenceTracker count;
  QuiescenceTracker others;
  CallWatchdog watch;
  InFlight work = count.begin();
};

TEST_F(CallWatchTest, HoldsTheWorkUntilTheCallIsOver) {
  EXPECT_EQ(begin(0), Begin::unwatched);
  EXPECT_TRUE(watch.in_call());
  EXPECT_FALSE(work);
  EXPECT_TRUE(held());
  EXPECT_TRUE(watch.end(work));
  EXPECT_FALSE(watch.in_call());
  EXPECT_TRUE(work); // whose it was
}

TEST_F(CallWatchTest, HoldsWorkForACallThatIsExpected) {
  watch.expect(std::exchange(work, {}));
  InFlight other = others.begin();
  watch.begin(0, other);
  watch.end(other);
  EXPECT_TRUE(held());
  begin(0);
  watch.end(work);
  work.reset();
  EXPECT_FALSE(held());
}

TEST_F(CallWatchTest, WantsAWatcherUntilOneFindsNoCall) {
  EXPECT_EQ(begin(100), Begin::unwatched);
  EXPECT_EQ(watch.time_left(300, 500ms), 300ms);
  EXPECT_EQ(watch.time_left(700, 500ms), -100ms);
  watch.end(work);
  EXPECT_EQ(begin(800), Begin::watched);
  watch.end(work);
  EXPECT_EQ(watch.time_left(900, 500ms), std::nullopt);
  EXPECT_EQ(begin(1000), Begin::unwatched);
}

TEST_F(CallWatchTest, CanBeWatchedAnew) {
  begin(0);
  watch.end(work);
  watch.watch_anew();
  EXPECT_EQ(begin(1), Begin::unwatched);
}

TEST_F(CallWatchTest, LetsWhoWaitsGoWhenItIsGivenUp) {
  begin(0);
  EXPECT_TRUE(watch.give_up());
  EXPECT_FALSE(held());
  EXPECT_TRUE(watch.in_call()); // it has not returned
  EXPECT_FALSE(watch.end(work));
  EXPECT_FALSE(work);
  work = others.begin();
  EXPECT_EQ(begin(1), Begin::refused);
  EXPECT_TRUE(work); // not taken
  EXPECT_FALSE(watch.give_up());
}

TEST(CallWatchdog, TellsSinceWhenItIsInACall) {
  CallWatchdog watch;
  EXPECT_EQ(watch.call_since(), std::nullopt);
  InFlight none;
  watch.begin(7, none);
  EXPECT_EQ(watch.call_since(), 7);
  watch.end(none);
  EXPECT_EQ(watch.call_since(), std::nullopt);
}

} // namespace
} // namespace parlour::actors
