#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/mqtt/device_list.hpp"
#include "tests/support/temporary_folder.hpp"

namespace parlour::adapters::mqtt {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;
using testing::StartsWith;

Expected<DeviceList> read(const std::string& text) {
  const test::TemporaryFolder folder;
  folder.write("devices.tsv", text);
  return DeviceList::read(folder.path() / "devices.tsv");
}

// The line and the message.
std::string mistake(const std::string& text) {
  const auto list = read(text);
  return list ? "none"
              : std::to_string(list.error().place.line) + ": " +
                    list.error().message;
}

TEST(DeviceList, TellsWhatTheApplicationCallsThings) {
  const auto list = read("device\troom\tvalue\tfrom\tto\tkind\n"
                         "lamp\t*\toff\t\t\tlight\n"
                         "heating\tkitchen\t20\t5\t30\tclimate\n"
                         "bell\thall\t\t\t\tbinary_sensor:doorbell\n");
  ASSERT_TRUE(list) << list.error().message;
  ASSERT_THAT(list->devices, SizeIs(3));
  EXPECT_THAT(list->entities, IsEmpty());
  EXPECT_EQ(list->devices[0].room, "*");
  EXPECT_EQ(list->devices[0].kind, "light");
  EXPECT_EQ(list->devices[0].from, std::nullopt);
  EXPECT_EQ(list->devices[1].from, 5);
  EXPECT_EQ(list->devices[1].to, 30);
  EXPECT_EQ(list->devices[2].kind, "binary_sensor");
  EXPECT_EQ(list->devices[2].device_class, "doorbell");
}

TEST(DeviceList, MayNameTopics) {
  const auto list =
      read("device\troom\tkind\tstate_topic\tcommand_topic\tpayload_on\n"
           "lamp\tkitchen\tlight\tk/s\tk/c\t1\n"
           "lamp\thall\tlight\t\t\t\n");
  ASSERT_TRUE(list) << list.error().message;
  EXPECT_THAT(list->devices, SizeIs(2));
  ASSERT_THAT(list->entities, SizeIs(1));
  const auto& lamp = list->entities[0];
  EXPECT_EQ(lamp.state.topic, "k/s");
  EXPECT_EQ(lamp.command_topic, "k/c");
  EXPECT_EQ(lamp.area, "kitchen");
  EXPECT_EQ(lamp.orders.at(0).payload, "1");
}

TEST(DeviceList, SaysWhatIsWrong) {
  EXPECT_THAT(mistake("device\troom\tvalue\nlamp\thall\toff\n"),
              HasSubstr("'kind'"));
  EXPECT_THAT(mistake("device\troom\tkind\n\n# none\nlamp\thall\tlantern\n"),
              AllOf(StartsWith("4: "), HasSubstr("not 'lantern'")));
  EXPECT_THAT(mistake("device\troom\tkind\tstate_topic\n"
                      "lamp\thall\tlight\ta/#\n"),
              HasSubstr("'a/#' has characters"));
  const auto none = DeviceList::read("/nowhere/devices.tsv");
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().kind, ErrorKind::file);
}

} // namespace
} // namespace parlour::adapters::mqtt
