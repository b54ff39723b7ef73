// Folders, a small schema and seed, and the plug-in as a session sees it.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/database/sqlite_database.hpp"
#include "tests/support/fake_plugin_host.hpp"
#include "tests/support/temporary_folder.hpp"

namespace parlour::adapters {

class DatabaseTest : public testing::Test {
protected:
  DatabaseTest() {
    host.data = (folder.path() / "data").string();
    host.application = folder.path().string();
    folder.write("schema.sql",
                 "-- the staff\ncreate table staff (\n"
                 "  id integer primary key, name text not null unique,\n"
                 "  level integer);\n");
    folder.write("seed.sql",
                 "insert into staff (name, level) values\n"
                 "('Dr. Jeffery Ho', 13), ('Tan Ah Kow', null), ('Lim', 13);");
  }

  Options file_options() const {
    return {
        {"file", "staff.db"}, {"schema", "schema.sql"}, {"seed", "seed.sql"}};
  }
  Options memory_options() const {
    auto options = file_options();
    options["file"] = ":memory:";
    return options;
  }

  Expected<void> start(const Options& options) {
    plugin = sqlite_database_factory().create();
    return plugin->start(host, options);
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
    const auto events = host.take_events();
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
  test::FakePluginHost host;
  std::unique_ptr<IPlugin> plugin;
};

} // namespace parlour::adapters
