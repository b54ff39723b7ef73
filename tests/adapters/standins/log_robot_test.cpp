#include "adapters/standins/log_robot.hpp"
#include "tests/adapters/standins/stand_in_fixture.hpp"

namespace parlour::adapters {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;
using testing::IsEmpty;

class LogRobotTest : public StandInTest {
protected:
  std::vector<std::string> after(Milliseconds time) {
    host.advance(time);
    return host.take_events();
  }
};

TEST_F(LogRobotTest, GoesAndGraspsInItsTime) {
  ASSERT_TRUE(start(log_robot_factory(), {}));
  EXPECT_THAT(tell("Goto", {"kitchen"}), IsEmpty());
  EXPECT_THAT(after(3999ms), IsEmpty());
  EXPECT_THAT(after(1ms), ElementsAre("Arrived(kitchen)"));
  EXPECT_THAT(tell("Grasp", {"cup"}), IsEmpty());
  EXPECT_THAT(after(2s), ElementsAre("Grasped(cup)"));
  EXPECT_THAT(tell("Sense", {"place"}), ElementsAre("Sensor(place, kitchen)"));
  EXPECT_THAT(tell("Sense", {"hand"}), ElementsAre("Sensor(hand, cup)"));
  EXPECT_THAT(tell("Release"), IsEmpty());
  EXPECT_THAT(tell("Sense", {"hand"}), ElementsAre("Sensor(hand, )"));
}

TEST_F(LogRobotTest, AnswersTheOrderThatItWasGiven) {
  ASSERT_TRUE(start(log_robot_factory(), {}));
  plugin->receive(test::message("Goto", {"kitchen"}, "s2", 9));
  host.advance(4s);
  ASSERT_EQ(host.events.size(), 1u);
  EXPECT_EQ(host.events[0].session, "s2");
  EXPECT_EQ(host.events[0].correlation, 9u);
}

TEST_F(LogRobotTest, StopsInTheMiddle) {
  ASSERT_TRUE(start(log_robot_factory(), {}));
  EXPECT_THAT(tell("Stop"), IsEmpty());
  tell("Goto", {"kitchen"});
  EXPECT_THAT(tell("Stop"), ElementsAre("Failed(stopped)"));
  EXPECT_EQ(host.pending(), 0u);
  EXPECT_THAT(after(1min), IsEmpty());
}

TEST_F(LogRobotTest, TakesOneOrderAtATime) {
  ASSERT_TRUE(start(log_robot_factory(), {{"travel", "1s"}}));
  tell("Goto", {"kitchen"});
  EXPECT_THAT(tell("Goto", {"hall"}),
              ElementsAre("Failed(another order came)"));
  EXPECT_THAT(after(1min), ElementsAre("Arrived(hall)"));
}

TEST_F(LogRobotTest, HoldsOneThing) {
  ASSERT_TRUE(start(log_robot_factory(), {{"grip", "0s"}}));
  tell("Grasp", {"cup"});
  EXPECT_THAT(after(0ms), ElementsAre("Grasped(cup)"));
  EXPECT_THAT(tell("Grasp", {"plate"}),
              ElementsAre("Failed(My hand is full: cup.)"));
}

TEST_F(LogRobotTest, KnowsWhatItIsToldThatItKnows) {
  ASSERT_TRUE(start(log_robot_factory(),
                    {{"places", "kitchen, hall"}, {"things", "cup"}}));
  EXPECT_THAT(tell("Goto", {"cellar"}),
              ElementsAre("Failed(I do not know the place 'cellar'.)"));
  EXPECT_THAT(tell("Grasp", {"moon"}),
              ElementsAre("Failed(I do not know the thing 'moon'.)"));
  EXPECT_THAT(tell("Goto", {"hall"}), IsEmpty());
  EXPECT_THAT(tell("Sense", {"smell"}),
              ElementsAre("Failed(There is no sensor 'smell'; there are place, "
                          "hand, battery.)"));
}

TEST_F(LogRobotTest, FailsAsTold) {
  ASSERT_TRUE(start(log_robot_factory(), {{"answer", "failed"}}));
  tell("Goto", {"hall"});
  EXPECT_THAT(after(4s), ElementsAre("Failed(The way is blocked.)"));
  tell("Grasp", {"cup"});
  EXPECT_THAT(after(2s), ElementsAre("Failed(It slips out of my hand.)"));
}

TEST_F(LogRobotTest, RefusesWrongOptions) {
  EXPECT_FALSE(start(log_robot_factory(), {{"answer", "maybe"}}));
  EXPECT_FALSE(start(log_robot_factory(), {{"travel", "far"}}));
  EXPECT_FALSE(start(log_robot_factory(), {{"grip", "firm"}}));
}

} // namespace
} // namespace parlour::adapters
