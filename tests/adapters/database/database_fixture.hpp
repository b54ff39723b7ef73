// DatabaseTest: a database plug-in as a session uses it, with a small schema
// and seed that both products accept.
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runtime/plugin/plugin.hpp"
#include "tests/support/fake_plugin_host.hpp"
#include "tests/support/temporary_folder.hpp"

namespace parlour::adapters {

// A host for plug-ins that fire events from a thread of their own.
class WaitingHost : public test::FakePluginHost {
public:
  void fire_event(Message event) override {
    const std::lock_guard lock(mutex_);
    FakePluginHost::fire_event(std::move(event));
    changed_.notify_all();
  }
  void log(const std::string& text) override {
    const std::lock_guard lock(mutex_);
    FakePluginHost::log(text);
    changed_.notify_all();
  }

  // Waits for at least `count` events and returns them as "Command(param, …)".
  std::vector<std::string> wait_for_events(std::size_t count) {
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, std::chrono::minutes(1),
                      [&] { return events.size() >= count; });
    return take_events();
  }
  bool wait_for_log() {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, std::chrono::minutes(1),
                             [&] { return !logs.empty(); });
  }

private:
  std::mutex mutex_;
  std::condition_variable changed_;
};

class DatabaseTest : public testing::Test {
protected:
  DatabaseTest() {
    host.data = (folder.path() / "data").string();
    host.application = folder.path().string();
    folder.write("schema.sql",
                 "-- the staff; of one house\ncreate table staff (\n"
                 "  id integer primary key /*! auto_increment */,\n"
                 "  name varchar(80) not null unique, level integer)\n"
                 "/*! character set utf8mb4 collate utf8mb4_nopad_bin */;\n");
    folder.write("seed.sql",
                 "insert into staff (name, level) values\n"
                 "('Dr. Jeffery Ho', 13), ('Tan Ah Kow', null), ('Lim', 13);");
  }

  virtual PluginFactory factory() const = 0;
  // Waits for the plug-in's answers and returns them.
  virtual std::vector<std::string> answers() = 0;

  static Options with(Options all, const std::string& name,
                      const std::string& value) {
    all[name] = value;
    return all;
  }

  Expected<void> start(const Options& options) {
    plugin = factory().create();
    return plugin->start(host, options);
  }

  void send(const SessionId& session, std::string command,
            std::vector<Value> params = {}) {
    plugin->receive(
        test::message(std::move(command), std::move(params), session));
  }
  // Sends a command and returns its answer: "Result([…])" or "Error(Kind,
  // message)".
  std::string tell(std::string command, std::vector<Value> params = {},
                   const SessionId& session = "s1") {
    send(session, std::move(command), std::move(params));
    const auto events = answers();
    return events.size() == 1 ? events[0]
                              : std::to_string(events.size()) + " events";
  }
  std::string query(const std::string& sql, Value values = {},
                    const SessionId& session = "s1") {
    return tell("Query", {sql, values}, session);
  }
  std::string write(const std::string& sql, Value values = {},
                    const SessionId& session = "s1") {
    return tell("Query", {sql, values, true}, session);
  }

  test::TemporaryFolder folder;
  WaitingHost host;
  std::unique_ptr<IPlugin> plugin;
};

} // namespace parlour::adapters
