#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/mqtt/device_table.hpp"

namespace parlour::adapters::mqtt {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

ListedDevice listed(const std::string& device, const std::string& room,
                    const std::string& kind,
                    const std::string& device_class = "") {
  ListedDevice made{device, room, kind, device_class, {}, {}};
  made.device_words = words_of(device);
  made.room_words = words_of(room);
  made.class_words = words_of(device_class);
  return made;
}

Entity thing(const std::string& kind, const std::string& name,
             const std::string& area = "", const std::string& device = "") {
  Entity made;
  made.id = kind + "/" + device + "/" + name + "/" + area;
  made.kind = kind;
  made.name = name;
  made.area = area;
  made.device = device;
  made.state.topic = made.id;
  return made;
}

class DeviceTableTest : public testing::Test {
protected:
  void add(Entity entity) {
    const auto message = entity.id;
    ASSERT_TRUE(table.set(message, {std::move(entity)}));
  }
  // The names of what is found.
  std::vector<std::string> find(const std::string& device,
                                const std::string& room) {
    std::vector<std::string> names;
    for (const auto* one : table.find(device, room))
      names.push_back(one->entity.name);
    return names;
  }
  std::string spoken(const std::string& device, const std::string& room) {
    const auto found = table.find(device, room);
    if (found.size() != 1)
      return "not one";
    const auto called = table.spoken(*found[0]);
    return called ? called->device + " in " + called->room : "nothing";
  }

  DeviceList list;
  DeviceTable table{list};
};

// Without a list, the kind, then the name, then a part of the name decides.
TEST_F(DeviceTableTest, FindsByKindAndName) {
  add(thing("light", "Ceiling", "Kitchen"));
  add(thing("light", "Table lamp", "Kitchen"));
  add(thing("switch", "Lamp", "Kitchen"));
  add(thing("light", "Hall ceiling", "Hall"));
  EXPECT_THAT(find("light", "kitchen"),
              UnorderedElementsAre("Ceiling", "Table lamp"));
  EXPECT_THAT(find("lamp", "KITCHEN"), ElementsAre("Lamp"));
  EXPECT_THAT(find("table", "kitchen"), ElementsAre("Table lamp"));
  EXPECT_THAT(find("ceiling", "hall"), ElementsAre("Hall ceiling"));
  EXPECT_THAT(find("light", "bedroom"), IsEmpty());
  EXPECT_THAT(find("oven", "kitchen"), IsEmpty());
  EXPECT_THAT(find("", "kitchen"), IsEmpty());
  EXPECT_EQ(spoken("ceiling", "hall"), "Hall ceiling in Hall");
}

TEST_F(DeviceTableTest, TakesTheRoomFromTheNameWhereNoAreaIsSuggested) {
  add(thing("light", "", "", "living_room/lamp"));
  EXPECT_EQ(table.find("lamp", "living room").size(), 1u);
  EXPECT_EQ(table.find("light", "Living Room").size(), 1u);
  EXPECT_THAT(table.find("light", "room lamp living"), IsEmpty());
}

TEST_F(DeviceTableTest, FindsWhatTheListMeans) {
  list.devices = {listed("lamp", "*", "light"),
                  listed("thermometer", "kitchen", "sensor", "temperature"),
                  listed("bell", "hall", "binary_sensor", "doorbell")};
  add(thing("light", "Ceiling", "Kitchen"));
  add(thing("switch", "lamp", "Kitchen"));
  auto warmth = thing("sensor", "T", "Kitchen");
  warmth.device_class = "temperature";
  add(warmth);
  add(thing("sensor", "Humidity", "Kitchen"));
  add(thing("binary_sensor", "Doorbell", "Hall"));
  EXPECT_THAT(find("lamp", "kitchen"), ElementsAre("Ceiling"));
  EXPECT_THAT(find("Lamp", "hall"), IsEmpty());
  EXPECT_THAT(find("thermometer", "kitchen"), ElementsAre("T"));
  EXPECT_THAT(find("bell", "hall"), ElementsAre("Doorbell"));
  // What the list does not name is found by its name, but not told.
  EXPECT_THAT(find("humidity", "kitchen"), ElementsAre("Humidity"));
  EXPECT_EQ(spoken("lamp", "kitchen"), "lamp in Kitchen");
  EXPECT_EQ(spoken("bell", "hall"), "bell in hall");
  EXPECT_EQ(spoken("humidity", "kitchen"), "nothing");
  EXPECT_EQ(table.spoken_of(), 3u);
  EXPECT_THAT(table.in_room("kitchen"),
              UnorderedElementsAre("lamp", "thermometer"));
}

TEST_F(DeviceTableTest, FollowsTopicsOfWhatComesAndGoes) {
  auto lamp = thing("light", "a", "Hall");
  lamp.state.topic = "shared";
  auto other = lamp;
  other.id = "other";
  add(lamp);
  EXPECT_THAT(table.changes().added, ElementsAre("shared"));
  add(other);
  EXPECT_THAT(table.changes().added, IsEmpty());
  EXPECT_EQ(table.readers("shared").size(), 2u);
  table.set(lamp.id, {});
  EXPECT_THAT(table.changes().removed, IsEmpty());
  // Announced anew with another topic.
  other.state.topic = "new";
  table.set("other", {other});
  const auto changes = table.changes();
  EXPECT_THAT(changes.added, ElementsAre("new"));
  EXPECT_THAT(changes.removed, ElementsAre("shared"));
  EXPECT_THAT(table.readers("shared"), IsEmpty());
  EXPECT_THAT(table.topics(), ElementsAre("new"));
  table.set("nobody", {});
  EXPECT_EQ(table.size(), 1u);
}

TEST_F(DeviceTableTest, KeepsTheStateOfWhatIsAnnouncedAgain) {
  const auto lamp = thing("light", "a", "Hall");
  add(lamp);
  table.find(lamp.id)->state = "on";
  add(lamp);
  EXPECT_EQ(table.find(lamp.id)->state, Value("on"));
  EXPECT_THAT(table.changes().removed, IsEmpty());
  auto moved = lamp;
  moved.state.topic = "elsewhere";
  add(moved);
  EXPECT_EQ(table.find(lamp.id)->state, Value());
}

TEST_F(DeviceTableTest, HasALimit) {
  for (std::size_t i = 0; i < DeviceTable::max_devices; ++i)
    add(thing("sensor", std::to_string(i)));
  EXPECT_FALSE(table.set("more", {thing("sensor", "more")}));
  EXPECT_EQ(table.size(), DeviceTable::max_devices);
  // What is announced anew with one thing too many stays as it was.
  EXPECT_FALSE(table.set(thing("sensor", "7").id,
                         {thing("sensor", "7"), thing("sensor", "more")}));
  EXPECT_EQ(table.size(), DeviceTable::max_devices);
  // What is known may be announced again.
  add(thing("sensor", "7"));
  table.set(thing("sensor", "7").id, {});
  EXPECT_TRUE(table.set("more", {thing("sensor", "more")}));
}

TEST(Device, IsThereUnlessItSaysOtherwise) {
  using State = AvailabilitySource::State;
  Device device;
  EXPECT_TRUE(device.is_available());
  device.sources = {State::unknown, State::unknown};
  EXPECT_TRUE(device.is_available());
  device.sources = {State::available, State::unavailable};
  device.latest_source = 0;
  EXPECT_TRUE(device.is_available());
  device.latest_source = 1;
  EXPECT_FALSE(device.is_available());
  device.entity.availability_mode = AvailabilityMode::any;
  EXPECT_TRUE(device.is_available());
  device.entity.availability_mode = AvailabilityMode::all;
  EXPECT_FALSE(device.is_available());
  device.sources = {State::unavailable, State::unavailable};
  device.entity.availability_mode = AvailabilityMode::any;
  EXPECT_FALSE(device.is_available());
}

TEST(Device, ForgetsAStateThatExpires) {
  Device device;
  device.state = 21;
  EXPECT_EQ(device.state_at(Moment() + Milliseconds(100'000)), Value(21));
  device.entity.expires_after = Milliseconds(60'000);
  EXPECT_EQ(device.state_at(Moment() + Milliseconds(60'000)), Value(21));
  EXPECT_EQ(device.state_at(Moment() + Milliseconds(60'001)), Value());
}

} // namespace
} // namespace parlour::adapters::mqtt
