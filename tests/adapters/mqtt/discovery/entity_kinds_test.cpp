#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/mqtt/discovery/entity_kinds.hpp"

namespace parlour::adapters::mqtt {
namespace {

using testing::ElementsAre;
using testing::SizeIs;

std::vector<Entity> all_of(const std::string& kind, const std::string& text) {
  const auto json = *read_json(text);
  Fields fields(*json.if_map());
  auto made = entities_of("id", kind, fields);
  EXPECT_EQ(fields.mistake(), "");
  return made;
}

Entity only(const std::string& kind, const std::string& text) {
  auto made = all_of(kind, text);
  EXPECT_THAT(made, SizeIs(1));
  return made.at(0);
}

// "word payload (states that show it)"
std::vector<std::string> orders(const Entity& entity) {
  std::vector<std::string> lines;
  for (const auto& order : entity.orders) {
    auto line = order.word + " " + order.payload + " (";
    for (const auto& state : order.shown_by)
      line += (line.ends_with('(') ? "" : " ") + state;
    lines.push_back(line + ")");
  }
  return lines;
}

std::string state(const Entity& entity, const std::string& payload) {
  const auto text = entity.state.value.apply(Payload(payload));
  const auto value = text ? meaning_of(entity, *text) : std::nullopt;
  return value ? to_string(*value) : "none";
}

TEST(EntityKinds, Light) {
  const auto lamp = only("light", R"({"stat_t": "s", "cmd_t": "c"})");
  EXPECT_THAT(orders(lamp), ElementsAre("on ON (on)", "off OFF (off)"));
  EXPECT_EQ(state(lamp, "ON"), "on");
  EXPECT_EQ(state(lamp, "OFF"), "off");
  EXPECT_EQ(state(lamp, "dim"), "none");
  EXPECT_FALSE(lamp.is_optimistic);
  EXPECT_FALSE(lamp.is_lock);
}

TEST(EntityKinds, LightWithPayloadsAndTemplate) {
  const auto lamp = only("light", R"({"stat_t": "s", "cmd_t": "c",
      "pl_on": 1, "pl_off": false, "stat_val_tpl": "{{ value_json.on }}"})");
  EXPECT_THAT(orders(lamp), ElementsAre("on 1 (on)", "off False (off)"));
  EXPECT_EQ(state(lamp, R"({"on": 1})"), "on");
  EXPECT_EQ(state(lamp, R"({"on": false})"), "off");
}

TEST(EntityKinds, LightThatSpeaksJson) {
  const auto lamp = only("light", R"({"schema": "json", "stat_t": "s",
      "cmd_t": "c", "brightness": true})");
  EXPECT_THAT(orders(lamp), ElementsAre(R"(on {"state":"ON"} (on))",
                                        R"(off {"state":"OFF"} (off))"));
  EXPECT_EQ(state(lamp, R"({"state": "ON", "brightness": 255})"), "on");
  EXPECT_EQ(state(lamp, R"({"brightness": 255})"), "none");
}

TEST(EntityKinds, SwitchWithoutAState) {
  const auto plug = only("switch", R"({"cmd_t": "c",
      "cmd_tpl": "{\"relay\": \"{{ value }}\"}"})");
  EXPECT_TRUE(plug.is_optimistic);
  EXPECT_THAT(orders(plug), ElementsAre(R"(on {"relay": "ON"} (on))",
                                        R"(off {"relay": "OFF"} (off))"));
}

TEST(EntityKinds, Lock) {
  const auto door = only("lock", R"({"stat_t": "s", "cmd_t": "c",
      "stat_locked": "LOCK", "stat_unlocked": "UNLOCK"})");
  EXPECT_TRUE(door.is_lock);
  EXPECT_THAT(orders(door),
              ElementsAre("open UNLOCK (open)", "closed LOCK (closed)",
                          "unlocked UNLOCK (unlocked open)",
                          "locked LOCK (locked closed)"));
  EXPECT_EQ(state(door, "LOCK"), "closed");
  EXPECT_EQ(state(door, "UNLOCK"), "open");
  EXPECT_EQ(state(door, "LOCKING"), "closing");
  EXPECT_EQ(state(door, "JAMMED"), "jammed");
}

TEST(EntityKinds, LockWithALatchOrACode) {
  const auto door = only("lock", R"({"stat_t": "s", "cmd_t": "c",
      "payload_open": "LATCH"})");
  EXPECT_EQ(orders(door)[0], "open LATCH (open)");
  EXPECT_EQ(orders(door)[2], "unlocked UNLOCK (unlocked open)");
  const auto coded = only("lock", R"({"stat_t": "s", "cmd_t": "c",
      "code_format": "[0-9]+"})");
  EXPECT_FALSE(coded.can_be_set());
}

TEST(EntityKinds, Cover) {
  const auto blind = only("cover", R"({"stat_t": "s", "cmd_t": "c"})");
  EXPECT_THAT(orders(blind), ElementsAre("open OPEN (open opening)",
                                         "closed CLOSE (closed closing)"));
  EXPECT_EQ(state(blind, "opening"), "opening");
  const auto gate = only("cover", R"({"cmd_t": "c", "pos_t": "p",
      "pos_tpl": "{{ value_json.position }}"})");
  EXPECT_EQ(gate.state.topic, "p");
  EXPECT_FALSE(gate.is_optimistic);
  EXPECT_EQ(state(gate, R"({"position": 30})"), "open");
  EXPECT_EQ(state(gate, R"({"position": 0})"), "closed");
}

TEST(EntityKinds, ClimateIsAHeatingAndAThermometer) {
  const auto both = all_of("climate", R"({"min_temp": 5, "max_temp": 30,
      "temp_cmd_t": "set", "temp_cmd_tpl": "{\"to\": {{ value }}}",
      "temp_stat_t": "z", "temp_stat_tpl": "{{ value_json.set }}",
      "curr_temp_t": "z", "curr_temp_tpl": "{{ value_json.is }}"})");
  ASSERT_THAT(both, SizeIs(2));
  EXPECT_EQ(both[0].kind, "sensor");
  EXPECT_EQ(both[0].device_class, "temperature");
  EXPECT_FALSE(both[0].can_be_set());
  const auto* message = R"({"set": 20, "is": 18.5})";
  EXPECT_EQ(state(both[0], message), "18.5");
  EXPECT_EQ(state(both[1], message), "20");
  ASSERT_TRUE(both[1].numbers);
  EXPECT_EQ(both[1].numbers->topic, "set");
  EXPECT_EQ(both[1].numbers->from, 5);
  EXPECT_EQ(both[1].numbers->to, 30);
  EXPECT_EQ(both[1].numbers->payload.apply(Payload("21.5")), R"({"to": 21.5})");
}

TEST(EntityKinds, Sensors) {
  const auto warmth = only("sensor", R"({"stat_t": "s", "exp_aft": 60})");
  EXPECT_EQ(warmth.expires_after, Milliseconds(60'000));
  EXPECT_FALSE(warmth.can_be_set());
  const auto motion = only("binary_sensor", R"({"stat_t": "s",
      "dev_cla": "motion", "pl_on": true, "pl_off": false,
      "val_tpl": "{{ value_json.occupancy }}"})");
  EXPECT_EQ(state(motion, R"({"occupancy": true})"), "on");
  EXPECT_EQ(state(motion, R"({"occupancy": false})"), "off");
  EXPECT_FALSE(motion.repeats);
  const auto window = only("binary_sensor", R"({"stat_t": "s",
      "dev_cla": "window"})");
  EXPECT_EQ(state(window, "ON"), "open");
  EXPECT_EQ(state(window, "OFF"), "closed");
  EXPECT_TRUE(
      only("binary_sensor", R"({"stat_t": "s", "off_dly": 5})").repeats);
}

TEST(EntityKinds, EventsRepeat) {
  const auto bell = only("event", R"({"stat_t": "s"})");
  EXPECT_TRUE(bell.repeats);
  EXPECT_EQ(state(bell, R"({"event_type": "press"})"), "press");
}

} // namespace
} // namespace parlour::adapters::mqtt
