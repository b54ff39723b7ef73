// Filling events, observed by what the robot says (engine rule 5).
#include <gtest/gtest.h>

#include "tests/script/dialogue/topics_of_tests.hpp"

namespace parlour::dialogue {
namespace {

TEST(FillingOfActs, OneUtteranceFillsEverything) {
  World world(booking);
  world.say(inform("Booking", {{"Time", "10:30"}, {"Place", "Hall"}}));
  EXPECT_EQ(world.said(), (Texts{"Started.", "Place Hall.", "Time 10:30.",
                                 "Filled.", "Completed."}));
}

TEST(FillingOfActs, ACorrectionRunsThatSlotOnly) {
  World world(booking);
  world.say(inform("Booking", {{"Place", "Hall"}}));
  world.said();
  world.say(act("correct", {}, {{"Place", "Garden"}}));
  EXPECT_EQ(world.said(), (Texts{"Place Garden.", "When?"}));
  EXPECT_EQ(world.slot("Booking", "Place"), "Garden");
}

TEST(FillingOfActs, ConfidenceDecidesHowSureItIs) {
  World world(booking);
  world.say(inform("Booking", {{"Place", slot_value("Hall", 0.3)}}));
  EXPECT_EQ(world.said(), (Texts{"Started.", "Where?"})); // as if not said
  world.say(inform({}, {{"Place", slot_value("Hall", 0.5)}}));
  EXPECT_EQ(world.said(),
            Texts{"[confirm Booking.Place {value: Hall, type: set}]"});
  world.say("confirm");
  EXPECT_EQ(world.said(), (Texts{"Place Hall.", "When?"}));
}

TEST(FillingOfActs, AFailingConstraintIsAScriptError) {
  World world(R"xml(
    <topic name="T"><slot name="A" type="Functional" question="A?"/>
      <constraint cond="this.A / 0 gt 1" message="No."/></topic>
    <handler name="Errors"><messages><component><Script>
      <Error><speak param="{_LPARAM2}:{_LPARAM3}"/></Error>
    </Script></component></messages></handler>)xml");
  world.say(inform("T", {{"A", 3}}));
  const auto said = world.said();
  ASSERT_EQ(said.size(), 3u); // refused, asked again, told
  EXPECT_NE(said[2].find("test.xml:"), std::string::npos) << said[2];
  EXPECT_EQ(world.seen(InspectionKind::error).size(), 1u);
}

} // namespace
} // namespace parlour::dialogue
