#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/mqtt/discovery/discovery_fields.hpp"

namespace parlour::adapters::mqtt {
namespace {

using testing::HasSubstr;
using testing::SizeIs;

TEST(DiscoveryFields, HaveLongAndShortNames) {
  const auto json = *read_json(R"({"stat_t": "a", "command_topic": "b",
      "pl_on": 1, "ret": "true", "opt": false, "max_temp": "30",
      "unheard_of": "x", "dev": {"sa": "Hall", "name": 7}})");
  Fields fields(*json.if_map());
  EXPECT_EQ(fields.topic("state_topic"), "a");
  EXPECT_EQ(fields.topic("command_topic"), "b");
  EXPECT_EQ(fields.topic("position_topic"), "");
  EXPECT_EQ(fields.text("payload_on"), "1");
  EXPECT_EQ(fields.text("payload_off", "OFF"), "OFF");
  EXPECT_EQ(fields.text("device"), std::nullopt);
  EXPECT_TRUE(fields.truth("retain", false));
  EXPECT_FALSE(fields.truth("optimistic", true));
  EXPECT_TRUE(fields.truth("enabled_by_default", true));
  EXPECT_EQ(fields.number("max_temp", 35), 30);
  EXPECT_EQ(fields.number("min_temp", 7), 7);
  EXPECT_EQ(fields.find("unheard_of"), nullptr);
  EXPECT_EQ(fields.device_text("suggested_area"), "Hall");
  EXPECT_EQ(fields.device_text("name"), "");
  EXPECT_EQ(fields.mistake(), "");
}

TEST(DiscoveryFields, KnowTheBaseTopic) {
  const auto json = *read_json(R"({"~": "house/lamp", "stat_t": "~/state",
      "cmd_t": "set/~", "pos_t": "a/~/b", "pl_on": "~"})");
  Fields fields(*json.if_map());
  EXPECT_EQ(fields.topic("state_topic"), "house/lamp/state");
  EXPECT_EQ(fields.topic("command_topic"), "set/house/lamp");
  EXPECT_EQ(fields.topic("position_topic"), "a/~/b");
  EXPECT_EQ(fields.text("payload_on"), "~");
}

TEST(DiscoveryFields, LookOutsideForWhatTheyDoNotHave) {
  const auto outer = *read_json(R"({"~": "d", "pl_on": "1", "avty_t": "~/x"})");
  const auto inner = *read_json(R"({"stat_t": "~/s"})");
  const Fields whole(*outer.if_map());
  Fields part(*inner.if_map(), &whole);
  EXPECT_EQ(part.topic("state_topic"), "d/s");
  EXPECT_EQ(part.text("payload_on"), "1");
  ASSERT_THAT(part.availability(), SizeIs(1));
  EXPECT_EQ(part.availability()[0].source.topic, "d/x");
}

TEST(DiscoveryFields, KeepTheFirstMistake) {
  const auto json = *read_json(R"({"stat_t": "a/#", "cmd_t": "b/+",
      "val_tpl": "{% x %}"})");
  Fields fields(*json.if_map());
  fields.topic("state_topic");
  fields.topic("command_topic");
  fields.value_template("value_template");
  EXPECT_THAT(fields.mistake(), HasSubstr("state_topic 'a/#'"));
}

TEST(DiscoveryFields, RefuseTopicsThatNobodyMayUse) {
  for (const auto& topic : {std::string("a/#"), std::string("+"),
                            std::string(65'536, 'x'), std::string("a\0b", 3)}) {
    const Map json{{"stat_t", topic}};
    Fields fields(json);
    fields.topic("state_topic");
    EXPECT_THAT(fields.mistake(), HasSubstr("must not have"));
  }
}

} // namespace
} // namespace parlour::adapters::mqtt
