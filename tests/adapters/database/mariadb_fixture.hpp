// A folder with a small schema and seed, and the plug-in MySQLDatabase on the
// test program's server as a session sees it.
#pragma once

#include <condition_variable>
#include <mutex>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/database/mariadb_database.hpp"
#include "tests/support/fake_plugin_host.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tools/bench/mariadb_server.hpp"

namespace parlour::adapters {

// Events come from the plug-in's own thread.
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

  // The next events, at least so many, as "Command(param, …)".
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

class MariaDBTest : public testing::Test {
protected:
  MariaDBTest() {
    host.data = folder.path().string();
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

  void SetUp() override {
    if (tools::MariaDBServer::program().empty())
      GTEST_SKIP() << "there is no mariadbd; install mariadb-server-core";
    server().go_on();
    start_server();
  }
  void TearDown() override {
    server().go_on();
    plugin = nullptr;
  }

  // The test program's, or that of a suite.
  virtual tools::MariaDBServer& server() {
    static const test::TemporaryFolder place;
    static tools::MariaDBServer shared(place.path());
    return shared;
  }
  void start_server() {
    const auto started = server().start();
    ASSERT_TRUE(started) << started.error().message;
  }

  // Of a database that is dropped in the end.
  Options options() {
    return {{"socket", server().socket()}, {"user", "root"},
            {"database", "test"},          {"schema", "schema.sql"},
            {"seed", "seed.sql"},          {"copy", "true"},
            {"busy-timeout", "30s"},       {"one-by-one", "true"}};
  }
  // Of one that stays, as long as the server's folder does.
  Options options_for(const std::string& database) {
    auto all = options();
    all["database"] = name_of(database);
    all["copy"] = "false";
    return all;
  }
  // Each test has its own.
  std::string name_of(const std::string& database) const {
    return database + "_" + std::to_string(number);
  }
  static Options with(Options all, const std::string& name,
                      const std::string& value) {
    all[name] = value;
    return all;
  }

  Expected<void> start(const Options& with) {
    plugin = mysql_database_factory().create();
    return plugin->start(host, with);
  }

  void send(const SessionId& session, std::string command,
            std::vector<Value> params = {}) {
    plugin->receive(
        test::message(std::move(command), std::move(params), session));
  }
  // "Result([…])" or "Error(Kind, message)".
  std::string tell(std::string command, std::vector<Value> params = {},
                   const SessionId& session = "s1") {
    send(session, std::move(command), std::move(params));
    const auto events = host.wait_for_events(1);
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

  const int number = [] {
    static int tests = 0;
    return ++tests;
  }();
  test::TemporaryFolder folder;
  WaitingHost host;
  std::unique_ptr<IPlugin> plugin;
};

} // namespace parlour::adapters
