// MQTTTest: the plug-in MQTTDevices as a session uses it. MosquittoTest: with a
// server of its own, and devices that the test plays.
#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/mqtt/mqtt_devices.hpp"
#include "adapters/mqtt/mqtt_link.hpp"
#include "runtime/plugin/test_host.hpp"
#include "tests/adapters/mqtt/mosquitto_server.hpp"
#include "tests/support/start_loop.hpp"
#include "tests/support/temporary_folder.hpp"

namespace parlour::adapters::mqtt {

constexpr Milliseconds long_enough{30'000};

class MQTTTest : public testing::Test {
protected:
  MQTTTest() {
    host.data = (folder.path() / "data").string();
    host.application = folder.path().string();
    folder.write("devices.tsv", "device\troom\tkind\n"
                                "lamp\t*\tlight\n"
                                "door\t*\tlock\n"
                                "bell\thall\tbinary_sensor:doorbell\n");
  }

  void SetUp() override {
    if (!MQTTClient::is_built_in())
      GTEST_SKIP() << "the program was built without libmosquitto";
  }

  // Quick where a user would be patient, patient where a busy machine needs it.
  static Options options(std::uint16_t port) {
    return {{"host", "127.0.0.1"},      {"port", std::to_string(port)},
            {"devices", "devices.tsv"}, {"pause", "10ms"},
            {"settle", "50ms"},         {"answer-timeout", "20s"}};
  }
  static Options with(Options all, const std::string& name,
                      const std::string& value) {
    all[name] = value;
    return all;
  }

  Expected<void> start(const Options& options) {
    plugin = mqtt_devices_factory().create();
    return plugin->start(host, options);
  }
  void send(std::string command, std::vector<Value> params) {
    Message message;
    message.command = std::move(command);
    message.params = std::move(params);
    message.session = "s1";
    message.correlation = 7;
    plugin->receive(message);
  }
  // The next event, as "Command param param".
  std::string next() {
    host.wait(
        [this] {
          for (auto& event : host.take_events())
            events.push_back(std::move(event));
          return !events.empty();
        },
        long_enough);
    if (events.empty())
      return "nothing";
    const auto event = events.front();
    events.erase(events.begin());
    auto text = event.command;
    for (const auto& param : event.params)
      text += " " + to_string(param);
    return event.correlation == 0 ? "unasked " + text : text;
  }
  std::string set(const std::string& device, const std::string& room,
                  Value value) {
    send("Set", {device, room, std::move(value)});
    return next();
  }
  std::string ask(const std::string& device, const std::string& room) {
    send("Ask", {device, room});
    return next();
  }
  // Whether a line with this text is logged, now or soon.
  testing::AssertionResult logs(const std::string& text) {
    const bool found = host.wait(
        [&] {
          for (auto& line : host.take_logs())
            logged.push_back(std::move(line));
          return std::ranges::any_of(logged, [&](const std::string& line) {
            return line.find(text) != std::string::npos;
          });
        },
        long_enough);
    return (found ? testing::AssertionSuccess() : testing::AssertionFailure())
           << testing::PrintToString(logged);
  }
  bool is_available(bool expected) {
    return host.wait([&] { return host.is_available() == expected; },
                     long_enough);
  }

  test::TemporaryFolder folder;
  TestHost host;
  std::vector<Message> events;
  std::vector<std::string> logged;
  std::unique_ptr<IPlugin> plugin;
};

// What the test plays: it publishes, and hears what is published.
class Home {
public:
  explicit Home(const ServerOptions& options)
      : loop_(test::start_loop()),
        link_(*loop_, options,
              {[this] { note("up"); }, [](const std::string&) {},
               [this](const Publication& one) {
                 note(one.topic + " " + one.payload);
               },
               [this](Ticket ticket) { note(std::to_string(ticket)); }}) {
    loop_->post([this] { link_.start(); });
    wait("up");
  }
  Home(const Home&) = delete;
  Home& operator=(const Home&) = delete;
  ~Home() {
    loop_->post([this] { link_.stop(); });
    loop_->stop();
  }

  // Waits until the server has it.
  void publish(const std::string& topic, const std::string& payload,
               bool retain = false) {
    const auto ticket = ++last_;
    loop_->post([=, this] { link_.publish({ticket, topic, payload, retain}); });
    wait(std::to_string(ticket));
  }
  void subscribe(const std::string& filter) {
    loop_->post([=, this] { link_.subscribe(filter); });
  }
  // Waits until this was heard: "topic payload".
  bool wait(const std::string& line) {
    std::unique_lock lock(mutex_);
    const auto is_there = [&] {
      return std::ranges::find(heard_, line) != heard_.end();
    };
    if (!changed_.wait_for(lock, long_enough, is_there))
      return false;
    heard_.erase(std::ranges::find(heard_, line));
    return true;
  }

private:
  void note(const std::string& line) {
    const std::lock_guard lock(mutex_);
    heard_.push_back(line);
    changed_.notify_all();
  }

  const std::unique_ptr<Loop> loop_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<std::string> heard_;
  Ticket last_ = 0;
  MQTTLink link_;
};

class MosquittoTest : public MQTTTest {
protected:
  void SetUp() override {
    start(server);
  }
  void TearDown() override {
    plugin = nullptr;
  }

  static void start(test::MosquittoServer& one) {
    if (test::MosquittoServer::program().empty() || !MQTTClient::is_built_in())
      GTEST_SKIP() << "there is no mosquitto, or no libmosquitto; install it "
                      "to run this test";
    one.start();
  }
  using MQTTTest::start;

  static ServerOptions server_options(std::uint16_t port) {
    ServerOptions made;
    made.host = "127.0.0.1";
    made.port = port;
    made.keep_alive = Milliseconds(60'000);
    made.connect_timeout = long_enough;
    made.pause = Milliseconds(10);
    return made;
  }

  static std::string lamp() {
    return R"({"~": "kitchen/lamp", "schema": "json", "stat_t": "~",
               "cmd_t": "~/set", "avty": [{"t": "~/there",
               "val_tpl": "{{ value_json.state }}"}],
               "dev": {"name": "Lamp", "sa": "Kitchen"}})";
  }
  static std::string lock() {
    return R"({"~": "front", "stat_t": "~/state", "cmd_t": "~/set",
               "dev": {"name": "Front door", "sa": "Hall"}})";
  }
  static void announce(Home& home) {
    home.publish("homeassistant/light/lamp/config", lamp(), true);
    home.publish("homeassistant/lock/n/front/config", lock(), true);
  }

  test::MosquittoServer server;
};

} // namespace parlour::adapters::mqtt
