#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/database/mariadb/connection/mariadb_dialect.hpp"

namespace parlour::adapters {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;

Expected<StatementKind> kind_of(const std::string& sql) {
  return statement_kind(sql, scan_sql(sql));
}

TEST(StatementKind, SaysWhatIsChanged) {
  for (auto sql : {"select 1", "(select 1) union (select 2)", "values (1)",
                   "-- a remark\nWITH a AS (select 1) select * from a"})
    EXPECT_EQ(kind_of(sql), StatementKind::reads) << sql;
  EXPECT_EQ(kind_of("Update a set b = 1"), StatementKind::changes_rows);
  EXPECT_EQ(kind_of("drop table a;"), StatementKind::changes_tables);
}

TEST(StatementKind, RefusesWhatIsNotForScripts) {
  for (auto sql : {"set names latin1", "begin", "/*! set @a = 1 */",
                   "grant all on a to b", "select 1; select 2"}) {
    const auto kind = kind_of(sql);
    ASSERT_FALSE(kind) << sql;
    EXPECT_EQ(kind.error().kind, ErrorKind::refused) << sql;
  }
  EXPECT_EQ(kind_of(" -- nothing").error().kind, ErrorKind::database);
}

TEST(DialectCommands, CarryTheTimesAndLimits) {
  MariaDBOptions options;
  options.busy_timeout = Milliseconds(1'200);
  options.query_timeout = Milliseconds(250);
  options.rows = 7;
  EXPECT_THAT(dialect_commands(options),
              Contains(AllOf(HasSubstr("innodb_lock_wait_timeout = 2"),
                             HasSubstr("max_statement_time = 0.25"),
                             HasSubstr("sql_select_limit = 8"))));
}

} // namespace
} // namespace parlour::adapters
