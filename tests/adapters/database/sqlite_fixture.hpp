// SQLiteTest: the plug-in SQLiteDatabase.
#pragma once

#include "adapters/database/sqlite/sqlite_database.hpp"
#include "tests/adapters/database/database_fixture.hpp"

namespace parlour::adapters {

class SQLiteTest : public DatabaseTest {
protected:
  PluginFactory factory() const override {
    return sqlite_database_factory();
  }
  std::vector<std::string> answers() override {
    return host.take_events();
  }

  // Options of a database in memory.
  Options options() const {
    return {{"schema", "schema.sql"}, {"seed", "seed.sql"}};
  }
  // Options of a database in a file.
  Options options_for(const std::string& database) const {
    return with(options(), "file", database + ".db");
  }
  Options file_options() const {
    return options_for("staff");
  }
};

} // namespace parlour::adapters
