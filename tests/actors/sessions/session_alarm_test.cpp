#include <caf/typed_event_based_actor.hpp>
#include <gmock/gmock.h>

#include "actors/sessions/session_alarm.hpp"
#include "tests/actors/bench.hpp"

namespace parlour::actors {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;
using testing::IsEmpty;

// A session that has nothing but an alarm.
class SessionAlarmTest : public testing::Test {
protected:
  void with_alarm(std::function<void(SessionAlarm&)> use) {
    user = bench.spawn(
        [=, this](session_actor::pointer self,
                  int) -> session_actor::behavior_type {
          auto alarm =
              std::make_shared<SessionAlarm>(self, bench.time, bench.bus);
          return session_with(self, {[=] { use(*alarm); },
                                     [this](const timer_due& what) {
                                       heard.push_back(what.id);
                                     },
                                     [=, this] {
                                       ++wakes;
                                       alarm->wake();
                                     }});
        },
        0);
    bench.send(user, begin_session{bench.work()});
  }

  Bench bench;
  session_actor user;
  std::vector<std::uint64_t> heard;
  int wakes = 0;
};

TEST_F(SessionAlarmTest, RingsInTheOrderOfTheTimes) {
  with_alarm([](SessionAlarm& alarm) {
    alarm.set(1, nine_o_clock + 20);
    alarm.set(2, nine_o_clock + 5);
    alarm.set(3, nine_o_clock + 20);
    alarm.set(4, nine_o_clock + 10);
    alarm.cancel(4);
    alarm.cancel(99);
  });
  EXPECT_EQ(bench.time.due_times.next()->due, nine_o_clock + 5);
  bench.scheduler->advance(10ms);
  EXPECT_THAT(heard, ElementsAre(2));
  bench.scheduler->advance(1h);
  EXPECT_THAT(heard, ElementsAre(2, 1, 3));
  EXPECT_FALSE(bench.time.due_times.next());
  EXPECT_TRUE(bench.time.work.none());
}

TEST_F(SessionAlarmTest, RingsAtOnceWhereTheTimeIsOver) {
  with_alarm([](SessionAlarm& alarm) { alarm.set(1, nine_o_clock - 5); });
  EXPECT_THAT(heard, ElementsAre(1));
}

// As the silence is watched anew in each turn: none of these costs a message.
TEST_F(SessionAlarmTest, WakesOnceForWhatIsSetAgainAndAgain) {
  with_alarm([](SessionAlarm& alarm) {
    for (std::uint64_t id = 1; id <= 100; ++id) {
      alarm.set(id, nine_o_clock + 1'000 + Timestamp(id));
      alarm.cancel(id - 1);
    }
  });
  bench.scheduler->advance(1h);
  EXPECT_THAT(heard, ElementsAre(100));
  EXPECT_EQ(wakes, 1);
}

TEST_F(SessionAlarmTest, RingsAfterADay) {
  with_alarm(
      [](SessionAlarm& alarm) { alarm.set(1, nine_o_clock + 86'400'000); });
  while (bench.time.now() < nine_o_clock + 82'800'000)
    bench.scheduler->advance(1h);
  EXPECT_THAT(heard, IsEmpty());
  bench.scheduler->advance(1h);
  EXPECT_THAT(heard, ElementsAre(1));
}

TEST_F(SessionAlarmTest, LeavesNothingBehind) {
  with_alarm(
      [](SessionAlarm& alarm) { alarm.set(1, nine_o_clock + 86'400'000); });
  bench.send(user, end_session{bench.work()});
  EXPECT_FALSE(bench.time.due_times.next());
  EXPECT_TRUE(bench.time.work.none());
}

} // namespace
} // namespace parlour::actors
