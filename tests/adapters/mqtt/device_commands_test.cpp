#include <gtest/gtest.h>

#include "adapters/mqtt/device_commands.hpp"

namespace parlour::adapters::mqtt {
namespace {

// "topic payload", or the error.
std::string command(const Device& device, const Value& value) {
  const auto made = command_for(device, {"thing", "hall"}, value);
  return made ? made->topic + " " + made->payload : made.error().message;
}

TEST(DeviceCommands, Words) {
  Device lamp;
  lamp.entity.command_topic = "set";
  lamp.entity.orders = {{"on", "ON", {"on"}}, {"off", "OFF", {"off"}}};
  EXPECT_EQ(command(lamp, "on"), "set ON");
  EXPECT_EQ(command(lamp, "Off"), "set OFF");
  EXPECT_EQ(command(lamp, true), "set ON");
  EXPECT_EQ(command(lamp, false), "set OFF");
  EXPECT_EQ(command(lamp, "dim"),
            "The thing in the hall takes on or off, not 'dim'.");
  EXPECT_EQ(command(lamp, Value()),
            "The thing in the hall takes on or off, not ''.");
}

TEST(DeviceCommands, Numbers) {
  Device heating;
  heating.entity.numbers = {"set", {}, 5, 35};
  EXPECT_EQ(command(heating, 20), "set 20");
  EXPECT_EQ(command(heating, "21.5"), "set 21.5");
  EXPECT_EQ(command(heating, 4.9),
            "The thing in the hall takes 5 to 35, not '4.9'.");
  EXPECT_EQ(command(heating, "warm"),
            "The thing in the hall takes 5 to 35, not 'warm'.");
  ListedDevice narrower;
  narrower.to = 30;
  heating.listed = {&narrower};
  EXPECT_EQ(command(heating, 31),
            "The thing in the hall takes 5 to 30, not '31'.");
}

TEST(DeviceCommands, NotForWhatOnlyMeasures) {
  EXPECT_EQ(command(Device(), 20), "The thing in the hall cannot be set from "
                                   "here.");
}

TEST(DeviceCommands, AreShownByStates) {
  EXPECT_TRUE(shows("on", {"on"}));
  EXPECT_FALSE(shows("off", {"on"}));
  EXPECT_TRUE(shows("opening", {"open", "opening"}));
  EXPECT_TRUE(shows(20.04, {20}));
  EXPECT_FALSE(shows(20.5, {20}));
  EXPECT_FALSE(shows(Value(), {0}));
}

TEST(DeviceCommands, NameTheirDevice) {
  EXPECT_EQ(subject({"lamp", "kitchen"}), "The lamp in the kitchen");
  EXPECT_EQ(subject({"lamp", ""}), "The lamp");
}

} // namespace
} // namespace parlour::adapters::mqtt
