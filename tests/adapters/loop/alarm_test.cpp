#include <future>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/loop/alarm.hpp"
#include "tests/support/start_loop.hpp"

namespace parlour::adapters {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;
using Steady = std::chrono::steady_clock;

class AlarmTest : public testing::Test {
protected:
  void on_loop(const Loop::Action& action) {
    std::promise<void> over;
    loop->post([&] {
      action();
      over.set_value();
    });
    over.get_future().wait();
  }

  // A test stops it before its alarms go.
  std::unique_ptr<Loop> loop = test::start_loop();
  std::promise<void> done;
};

TEST_F(AlarmTest, RingsOnceAndNotBeforeItsTime) {
  const auto start = Steady::now();
  int times = 0;
  Alarm alarm(*loop, [&] {
    ++times;
    done.set_value();
  });
  on_loop([&] { alarm.set(start + 2ms); });
  done.get_future().wait();
  EXPECT_GE(Steady::now(), start + 2ms);
  loop->stop();
  EXPECT_EQ(times, 1);
}

// The same order whichever of them is set first.
TEST_F(AlarmTest, RingsInTheOrderOfTheMoments) {
  std::vector<int> rung;
  Alarm first(*loop, [&] { rung.push_back(1); });
  Alarm second(*loop, [&] {
    rung.push_back(2);
    done.set_value();
  });
  on_loop([&] {
    const auto now = Steady::now();
    second.set(now + 1h);
    second.set(now + 2ms); // earlier than before
    first.set(now - 1h);
    first.set(now + 1ms); // later than before
  });
  done.get_future().wait();
  loop->stop();
  EXPECT_THAT(rung, ElementsAre(1, 2));
}

TEST_F(AlarmTest, CanBeSetAgainAndTakenBack) {
  int times = 0;
  Alarm never_rings(*loop, [] { FAIL(); });
  Alarm alarm(*loop, [&] {
    if (++times == 3)
      return done.set_value();
    alarm.set(Steady::now());
  });
  on_loop([&] {
    never_rings.set(Steady::now());
    never_rings.set(Alarm::never);
    alarm.set(Steady::now());
  });
  done.get_future().wait();
  loop->stop();
  EXPECT_EQ(times, 3);
}

TEST_F(AlarmTest, IsSilentOnceItIsDestroyed) {
  auto gone = std::make_unique<Alarm>(*loop, [] { FAIL(); });
  Alarm alarm(*loop, [&] { done.set_value(); });
  on_loop([&] {
    const auto now = Steady::now();
    gone->set(now);
    alarm.set(now + 1ms);
    gone.reset();
  });
  done.get_future().wait();
  loop->stop();
}

} // namespace
} // namespace parlour::adapters
