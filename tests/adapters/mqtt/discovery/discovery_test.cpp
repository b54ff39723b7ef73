#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/mqtt/discovery/discovery.hpp"

namespace parlour::adapters::mqtt {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

Discovery read(const std::string& kind, const std::string& json) {
  return read_discovery("ha/" + kind + "/x/config", kind, Payload(json));
}

TEST(Discovery, KnowsItsTopics) {
  EXPECT_THAT(discovery_filters("ha"),
              ElementsAre("ha/+/+/config", "ha/+/+/+/config"));
  EXPECT_EQ(discovered_kind("ha", "ha/light/x/config"), "light");
  EXPECT_EQ(discovered_kind("ha", "ha/sensor/node/x/config"), "sensor");
  EXPECT_EQ(discovered_kind("ha", "ha/light/x/state"), std::nullopt);
  EXPECT_EQ(discovered_kind("ha", "hall/light/x/config"), std::nullopt);
  EXPECT_EQ(discovered_kind("a/b", "a/b/light/x/config"), "light");
}

TEST(Discovery, ReadsLongAndShortNames) {
  for (const auto* json :
       {R"({"name": "Ceiling", "state_topic": "k/lamp/state",
            "command_topic": "k/lamp/set", "retain": true,
            "availability_topic": "k/lamp/there",
            "payload_available": "yes", "payload_not_available": "no",
            "device": {"name": "Lamp", "suggested_area": "Kitchen"}})",
        R"({"~": "k/lamp", "name": "Ceiling", "stat_t": "~/state",
            "cmd_t": "~/set", "ret": true, "avty_t": "~/there",
            "pl_avail": "yes", "pl_not_avail": "no",
            "dev": {"name": "Lamp", "sa": "Kitchen"}})",
        R"({"~": "lamp/state", "name": "Ceiling", "stat_t": "k/~",
            "cmd_t": "k/lamp/set", "ret": true,
            "avty": [{"t": "k/lamp/there", "pl_avail": "yes",
                      "pl_not_avail": "no"}],
            "dev": {"name": "Lamp", "sa": "Kitchen"}})"}) {
    const auto found = read("light", json);
    ASSERT_THAT(found.mistakes, IsEmpty());
    ASSERT_THAT(found.entities, SizeIs(1));
    const auto& lamp = found.entities[0];
    EXPECT_EQ(lamp.name, "Ceiling");
    EXPECT_EQ(lamp.device, "Lamp");
    EXPECT_EQ(lamp.area, "Kitchen");
    EXPECT_EQ(lamp.state.topic, "k/lamp/state");
    EXPECT_EQ(lamp.command_topic, "k/lamp/set");
    EXPECT_TRUE(lamp.retains_commands);
    ASSERT_THAT(lamp.availability, SizeIs(1));
    EXPECT_EQ(lamp.availability[0].source.topic, "k/lamp/there");
    EXPECT_EQ(lamp.availability[0].available, "yes");
    EXPECT_EQ(lamp.availability[0].unavailable, "no");
  }
}

TEST(Discovery, ReadsADeviceWithSeveralThings) {
  const auto found = read("device", R"({
      "~": "plug", "dev": {"name": "Plug", "sa": "Hall"},
      "avty_t": "~/there",
      "cmps": {"relay": {"p": "switch", "stat_t": "~/s", "cmd_t": "~/c"},
               "heat": {"p": "sensor", "dev_cla": "temperature",
                        "stat_t": "~/t"},
               "picture": {"p": "camera", "t": "~/p"},
               "broken": {"p": "switch"}}})");
  ASSERT_THAT(found.entities, SizeIs(2));
  EXPECT_EQ(found.entities[1].id, "ha/device/x/config#heat");
  EXPECT_EQ(found.entities[1].state.topic, "plug/t");
  EXPECT_EQ(found.entities[0].kind, "switch");
  EXPECT_EQ(found.entities[0].area, "Hall");
  EXPECT_EQ(found.entities[0].availability.at(0).source.topic, "plug/there");
  ASSERT_THAT(found.mistakes, SizeIs(1));
  EXPECT_THAT(found.mistakes[0], HasSubstr("#broken: it has neither"));
}

TEST(Discovery, PassesOverWhatIsNotForUsers) {
  for (const auto* more : {R"("entity_category": "config")",
                           R"("ent_cat": "diagnostic")", R"("en": false)"}) {
    const auto found =
        read("switch", std::string(R"({"cmd_t": "c", )") + more + "}");
    EXPECT_THAT(found.entities, IsEmpty()) << more;
    EXPECT_THAT(found.mistakes, IsEmpty()) << more;
  }
  EXPECT_THAT(read("camera", "{").mistakes, IsEmpty());
}

TEST(Discovery, SaysWhatIsWrong) {
  const auto mistake = [](const std::string& kind, const std::string& json) {
    const auto found = read(kind, json);
    return found.mistakes.size() == 1 && found.entities.empty()
               ? found.mistakes[0]
               : std::to_string(found.mistakes.size()) + " mistakes";
  };
  EXPECT_EQ(mistake("light", "{\"cmd_t\": "),
            "ha/light/x/config: this is no JSON object");
  EXPECT_EQ(mistake("light", "[1]"),
            "ha/light/x/config: this is no JSON object");
  EXPECT_THAT(mistake("light", "{}"), HasSubstr("neither a state_topic"));
  EXPECT_THAT(mistake("switch", R"({"cmd_t": "a/#"})"),
              HasSubstr("the command_topic 'a/#' has characters"));
  EXPECT_THAT(mistake("sensor", R"({"stat_t": "a/+/b"})"),
              HasSubstr("the state_topic 'a/+/b' has characters"));
  EXPECT_THAT(
      mistake("sensor", R"({"stat_t": "a", "val_tpl": "{{ value + 1 }}"})"),
      HasSubstr("the template '{{ value + 1 }}' is not supported"));
  EXPECT_THAT(mistake("sensor", R"({"stat_t": "a", "avty": [{"t": "b",
                            "val_tpl": "{% x %}"}]})"),
              HasSubstr("the template '{% x %}' is not supported"));
  EXPECT_THAT(mistake("light", R"({"cmd_t": "a", "schema": "template"})"),
              HasSubstr("switched by a template"));
  EXPECT_THAT(mistake("device", R"({"cmps": 7})"), HasSubstr("components"));
}

// Fields of the wrong type count as not there.
TEST(Discovery, BearsAnyJson) {
  for (const auto* kind : {"light", "switch", "lock", "cover", "climate",
                           "sensor", "binary_sensor", "event", "device"})
    for (const auto* json :
         {R"({"name": {}, "stat_t": [], "cmd_t": {"a": 1}, "dev": "x"})",
          R"({"stat_t": 7, "dev": {"name": 1, "sa": []}, "avty": 5})",
          R"({"stat_t": "a", "avty": [1, "x", {}, {"t": 4}]})",
          R"({"stat_t": "a", "min_temp": "cold", "exp_aft": -1, "~": 5})",
          R"({"stat_t": "a", "exp_aft": 1e300, "cmps": {"a": 1, "b": {}}})"})
      read(kind, json);
}

} // namespace
} // namespace parlour::adapters::mqtt
