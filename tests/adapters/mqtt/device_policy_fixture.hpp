// DevicePolicyTest: what a policy decides, as lines.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/mqtt/device_policy.hpp"

namespace parlour::adapters::mqtt {

class DevicePolicyTest : public testing::Test {
protected:
  using Lines = std::vector<std::string>;

  static constexpr Milliseconds settle{500};
  static constexpr Milliseconds patience{5'000};

  // -- what happens -----------------------------------------------------------

  void connect() {
    policy.connected(now);
  }
  // Connects, announces a lamp and a lock, and lets them settle.
  void begin() {
    connect();
    announce("light/lamp", lamp());
    announce("lock/door", lock());
    wait(settle);
    lines();
  }
  void announce(const std::string& thing, const std::string& json) {
    policy.received("ha/" + thing + "/config", json, true, now);
    policy.decide(now);
  }
  void says(const std::string& topic, const std::string& payload,
            bool retained = false) {
    policy.received(topic, payload, retained, now);
    policy.decide(now);
  }
  void wait(Milliseconds time) {
    now += time;
    policy.decide(now);
  }
  void order(const std::string& command, std::vector<Value> params) {
    Message message;
    message.command = command;
    message.params = std::move(params);
    policy.order(message, now);
  }
  void set(const std::string& device, const std::string& room, Value value) {
    order("Set", {device, room, std::move(value)});
  }
  void ask(const std::string& device, const std::string& room) {
    order("Ask", {device, room});
  }

  static std::string lamp(const std::string& base = "lamp",
                          const std::string& area = "Kitchen") {
    return R"({"~": ")" + base +
           R"(", "stat_t": "~/s", "cmd_t": "~/c", "avty_t": "~/there",
            "dev": {"sa": ")" +
           area + R"("}})";
  }
  static std::string lock() {
    return R"({"name": "front", "stat_t": "door/s", "cmd_t": "door/c",
               "dev": {"sa": "Hall"}})";
  }

  // -- what follows -----------------------------------------------------------

  Lines lines() {
    Lines all;
    for (const auto& deed : policy.deeds())
      all.push_back(
          std::visit([](const auto& one) { return line(one); }, deed));
    return all;
  }
  static std::string line(const Subscribe& deed) {
    return "subscribe " + deed.filter;
  }
  static std::string line(const Unsubscribe& deed) {
    return "unsubscribe " + deed.filter;
  }
  static std::string line(const Publish& deed) {
    return "publish " + deed.topic + " " + deed.payload +
           (deed.retain ? " retained" : "");
  }
  static std::string line(const Answer& deed) {
    return deed.command + texts(deed.params);
  }
  static std::string line(const News& deed) {
    return "news" + texts(deed.params);
  }
  static std::string line(const Log& deed) {
    return "log " + deed.text;
  }
  static std::string texts(const std::vector<Value>& values) {
    std::string text;
    for (const auto& value : values)
      text += " " + to_string(value);
    return text;
  }

  static DeviceList list() {
    DeviceList made;
    for (const auto& [device, kind] :
         {std::pair("lamp", "light"), std::pair("door", "lock"),
          std::pair("heating", "climate"), std::pair("thermometer", "sensor"),
          std::pair("bell", "event")}) {
      ListedDevice one{device, "*", kind, {}, {}, {}};
      one.device_words = words_of(device);
      made.devices.push_back(one);
    }
    return made;
  }

  Moment now{};
  DevicePolicy policy{{"ha", patience, settle}, list()};
};

} // namespace parlour::adapters::mqtt
