// MariaDBTest: the plug-in MySQLDatabase, with a server that the test program
// starts.
#pragma once

#include "adapters/database/mariadb/mariadb_database.hpp"
#include "tests/adapters/database/database_fixture.hpp"
#include "tools/bench/database/mariadb_server.hpp"

namespace parlour::adapters {

class MariaDBTest : public DatabaseTest {
protected:
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

  // The server that all tests of the program share; a suite may have its own.
  virtual tools::MariaDBServer& server() {
    static const test::TemporaryFolder place;
    static tools::MariaDBServer shared(place.path());
    return shared;
  }
  void start_server() {
    const auto started = server().start();
    ASSERT_TRUE(started) << started.error().message;
  }

  // Options of a database that is dropped in the end.
  Options options() {
    return {{"socket", server().socket()}, {"user", "root"},
            {"database", "test"},          {"schema", "schema.sql"},
            {"seed", "seed.sql"},          {"copy", "true"},
            {"busy-timeout", "30s"},       {"one-by-one", "true"}};
  }
  // Options of a database that lives as long as the server.
  Options options_for(const std::string& database) {
    auto all = options();
    all["database"] = name_of(database);
    all["copy"] = "false";
    return all;
  }
  // A database's name for this test alone.
  std::string name_of(const std::string& database) const {
    return database + "_" + std::to_string(number);
  }
  PluginFactory factory() const override {
    return mysql_database_factory();
  }
  std::vector<std::string> answers() override {
    return host.wait_for_events(1);
  }

  const int number = [] {
    static int tests = 0;
    return ++tests;
  }();
};

} // namespace parlour::adapters
