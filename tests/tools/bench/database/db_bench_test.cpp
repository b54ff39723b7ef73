#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tools/bench/database/db_bench.hpp"
#include "tools/bench/database/mariadb_server.hpp"

namespace parlour::tools {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

TEST(DbBench, a_row_tells_its_figure_and_its_bar) {
  std::ostringstream out;
  EXPECT_TRUE(db_bench({1, "sqlite"}, out)) << out.str();
  EXPECT_THAT(out.str(), HasSubstr("SQLite in memory"));
  EXPECT_THAT(out.str(), HasSubstr("of its speed, bar 0.60"));
  EXPECT_THAT(out.str(), Not(HasSubstr("MariaDB")));
}

TEST(DbBench, asks_a_server_where_there_is_one) {
  std::ostringstream out;
  const bool is_there = !MariaDBServer::program().empty();
  EXPECT_EQ(db_bench({1, "mariadb"}, out), is_there) << out.str();
  EXPECT_THAT(out.str(), HasSubstr(is_there ? "bar 0.85" : "mariadbd"));
}

TEST(DbBench, has_rows) {
  EXPECT_THAT(db_bench_rows(),
              ElementsAre("sqlite", "mariadb-1", "mariadb", "mariadb-16"));
}

} // namespace
} // namespace parlour::tools
