#include "actors/sessions/timer.hpp"
#include "tests/actors/node_fixture.hpp"

namespace parlour::actors {
namespace {

using TimerTest = NodeFixture;

constexpr const char* reminders = R"(
  <handler name="Pipeline"><messages><component>
    <ASR><RecognitionResult>
      <if cond="_LPARAM1 == 'stop'">
        <cancel timer="tea"/>
      <else>
        <timer name="tea" after="3s"><speak param="tea is ready"/></timer>
      </else>
      </if>
    </RecognitionResult></ASR>
  </component></messages></handler>)";

TEST_F(TimerTest, RingsWhenItsTimeHasCome) {
  start(reminders);
  EXPECT_THAT(say({"go"}), IsEmpty());
  EXPECT_EQ(node->now(), nine_o_clock);
  EXPECT_FALSE(node->step_to_next_due(2999ms));
  EXPECT_EQ(node->now(), nine_o_clock);
  EXPECT_TRUE(node->step_to_next_due(3s));
  EXPECT_EQ(node->now(), nine_o_clock + 3000);
  EXPECT_THAT(said(), ElementsAre("tea is ready"));
}

TEST_F(TimerTest, IsCancelled) {
  start(reminders);
  say({"go", "stop"});
  node->advance(10s);
  EXPECT_EQ(node->now(), nine_o_clock + 10000);
  EXPECT_THAT(said(), IsEmpty());
}

TEST_F(TimerTest, EndsWithItsSession) {
  start(reminders);
  say({"go"});
  node->end(node->session_at(seat));
  node->run_until_quiet();
  EXPECT_FALSE(node->step_to_next_due(1h));
  EXPECT_THAT(said(), IsEmpty());
}

TEST_F(TimerTest, IsInterruptedInRealTime) {
  options.virtual_start.reset();
  start(reminders);
  say({"go"});
  node->interrupt();
  EXPECT_FALSE(node->step_to_next_due(1h));
  EXPECT_THAT(said(), IsEmpty());
}

} // namespace
} // namespace parlour::actors
