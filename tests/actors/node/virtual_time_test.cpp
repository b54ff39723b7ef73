#include "tests/actors/bench.hpp"

namespace parlour::actors {
namespace {

class VirtualDriveTest : public testing::Test {
protected:
  // As an actor would: a delay of CAF's and its entry among the due times.
  DueTimes::Id ring_after(Milliseconds after) {
    auto& times = bench.time.due_times;
    const auto id =
        times.add(nine_o_clock + after.count(), DueTimes::Of::session);
    bench.spawn(
        [this, id, after](caf::event_based_actor* self, int) {
          self->delayed_send(self, after, caf::ok_atom::value);
          return caf::behavior{[this, id, self](caf::ok_atom) {
            rung.push_back(scheduler.clock().now() - nine_o_clock);
            bench.time.due_times.remove(id);
            self->quit();
          }};
        },
        0);
    return id;
  }

  Bench bench;
  Scheduler& scheduler = *bench.scheduler;
  std::vector<Timestamp> rung;
};

TEST_F(VirtualDriveTest, TimeStandsStillByItself) {
  ring_after(10ms);
  EXPECT_TRUE(scheduler.run_until_quiet());
  EXPECT_EQ(scheduler.clock().now(), nine_o_clock);
  EXPECT_FALSE(scheduler.step_to_next_due(9ms));
  EXPECT_EQ(scheduler.clock().now(), nine_o_clock);
  EXPECT_THAT(rung, IsEmpty());
}

TEST_F(VirtualDriveTest, JumpsFromDueTimeToDueTime) {
  ring_after(1h);
  ring_after(10ms);
  EXPECT_TRUE(scheduler.step_to_next_due(2h));
  EXPECT_THAT(rung, ElementsAre(10));
  EXPECT_TRUE(scheduler.step_to_next_due(2h));
  EXPECT_THAT(rung, ElementsAre(10, 3600000));
  EXPECT_FALSE(scheduler.step_to_next_due(2h));
}

TEST_F(VirtualDriveTest, AdvancesThroughAllThatFallsDue) {
  ring_after(30ms);
  ring_after(20ms);
  ring_after(50ms);
  scheduler.advance(40ms);
  EXPECT_THAT(rung, ElementsAre(20, 30));
  EXPECT_EQ(scheduler.clock().now(), nine_o_clock + 40);
}

TEST_F(VirtualDriveTest, IsInterrupted) {
  ring_after(10ms);
  bench.time.work.interrupt();
  EXPECT_FALSE(scheduler.run_until_quiet());
  EXPECT_FALSE(scheduler.step_to_next_due(1h));
  scheduler.advance(1h);
  EXPECT_EQ(scheduler.clock().now(), nine_o_clock);
  bench.time.work.forget_interrupt();
  EXPECT_TRUE(scheduler.run_until_quiet());
}

TEST_F(VirtualDriveTest, SaysWhetherItCame) {
  EXPECT_TRUE(scheduler.run_until([] { return true; }, 0ms));
  EXPECT_FALSE(scheduler.run_until([] { return false; }, 0ms));
  EXPECT_FALSE(scheduler.detaches());
}

} // namespace
} // namespace parlour::actors
