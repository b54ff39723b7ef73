#include "adapters/standins/log_devices.hpp"
#include "tests/adapters/standins/stand_in_fixture.hpp"

namespace parlour::adapters {
namespace {

using testing::ElementsAre;

class LogDevicesTest : public StandInTest {
protected:
  LogDevicesTest() {
    folder.write("devices.tsv", "device\troom\tvalue\tfrom\tto\n"
                                "lamp\tkitchen\toff\t\t\n"
                                "heating\t*\t20\t5\t30\n");
  }

  Expected<void> start_with(const std::string& file) {
    return start(log_devices_factory(), {{"devices", file}});
  }
};

TEST_F(LogDevicesTest, TellsWhatWasSet) {
  ASSERT_TRUE(start_with("devices.tsv"));
  EXPECT_THAT(tell("Ask", {"lamp", "kitchen"}),
              ElementsAre("State(lamp, kitchen, off)"));
  EXPECT_THAT(tell("Set", {"lamp", "kitchen", "on"}),
              ElementsAre("State(lamp, kitchen, on)"));
  EXPECT_THAT(tell("Ask", {"lamp", "kitchen"}),
              ElementsAre("State(lamp, kitchen, on)"));
  EXPECT_THAT(tell("Ask", {"Lamp", "Kitchen"}),
              ElementsAre("State(Lamp, Kitchen, on)"));
}

TEST_F(LogDevicesTest, KeepsRoomsApart) {
  ASSERT_TRUE(start_with("devices.tsv"));
  tell("Set", {"heating", "kitchen", 23});
  EXPECT_THAT(tell("Ask", {"heating", "bedroom"}),
              ElementsAre("State(heating, bedroom, 20)"));
}

TEST_F(LogDevicesTest, RefusesWhatIsNotThere) {
  ASSERT_TRUE(start_with("devices.tsv"));
  EXPECT_THAT(tell("Ask", {"lamp", "cellar"}),
              ElementsAre("Failed(There is no 'lamp' in 'cellar'.)"));
  EXPECT_THAT(tell("Set", {"", ""}),
              ElementsAre("Failed(There is no '' in ''.)"));
}

TEST_F(LogDevicesTest, RefusesValuesOutOfRange) {
  ASSERT_TRUE(start_with("devices.tsv"));
  EXPECT_THAT(tell("Set", {"heating", "kitchen", 40}),
              ElementsAre("Failed(The heating takes 5 to 30, not 40.)"));
  EXPECT_THAT(tell("Set", {"heating", "kitchen", "warm"}),
              ElementsAre("Failed(The heating takes 5 to 30, not warm.)"));
  EXPECT_THAT(tell("Set", {"lamp", "kitchen"}),
              ElementsAre("Failed(There is no value to set.)"));
  EXPECT_THAT(tell("Set", {"heating", "kitchen", 30}),
              ElementsAre("State(heating, kitchen, 30)"));
}

TEST_F(LogDevicesTest, NeedsItsFile) {
  EXPECT_FALSE(start_with(""));
  EXPECT_FALSE(start_with("nothing.tsv"));
  EXPECT_FALSE(start_with("../devices.tsv"));
}

} // namespace
} // namespace parlour::adapters
