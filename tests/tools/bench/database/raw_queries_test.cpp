#include <gtest/gtest.h>

#include "tools/bench/database/raw_queries.hpp"

namespace parlour::tools {
namespace {

// Twice "a description of the facility number 0 on the floor", or 7.
TEST(RawQueries, read_what_is_there) {
  const auto measured = raw_sqlite(2);
  ASSERT_TRUE(measured);
  EXPECT_EQ(measured->result, "102");
  EXPECT_GT(measured->nanoseconds, 0);
}

TEST(RawQueries, say_where_there_is_no_server) {
  const auto measured = raw_mariadb(MariaDBServer("/nowhere"), 1, 1);
  ASSERT_FALSE(measured);
  EXPECT_EQ(measured.error().kind, ErrorKind::offline);
}

} // namespace
} // namespace parlour::tools
