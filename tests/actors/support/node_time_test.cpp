#include <thread>

#include <gtest/gtest.h>

#include "actors/support/node_time.hpp"

namespace parlour::actors {
namespace {

class Noon : public Clock {
  Timestamp now() const override {
    return 43'200'000;
  }
};

TEST(NodeTime, WakesWhoWaitsForADueTimeToGo) {
  const Noon noon;
  NodeTime time(noon, MainThreadQueue::Kind::open);
  const auto id = time.due_times.add(time.now() + 5, DueTimes::Of::session);
  std::thread fires([&] { time.due_times.remove(id); });
  EXPECT_TRUE(time.work.wait([&] { return !time.due_times.has(id); }));
  EXPECT_EQ(time.now(), 43'200'000);
  fires.join();
}

} // namespace
} // namespace parlour::actors
