#include <gtest/gtest.h>

#include "script/compiler/sql_check.hpp"

namespace parlour::script {

TEST(SqlCheck, takes_one_select) {
  EXPECT_EQ(wrong_select("select a from b where c = ';'"), "");
  EXPECT_EQ(wrong_select("  SELECT 1; "), "");
  EXPECT_EQ(wrong_select("with x as (select 1) select * from x"), "");
  EXPECT_EQ(wrong_select("delete from b"), "expected one select statement");
  EXPECT_EQ(wrong_select("selected"), "expected one select statement");
  EXPECT_EQ(wrong_select("select 1; drop table b"),
            "expected one statement only; there is more behind the ';'");
  EXPECT_EQ(wrong_select("select 'a"),
            "a quotation mark in this statement does not end");
}

TEST(SqlCheck, knows_names_of_tables_and_columns) {
  EXPECT_TRUE(is_sql_name("level"));
  EXPECT_TRUE(is_sql_name("rr_facility.level"));
  EXPECT_FALSE(is_sql_name("level;"));
  EXPECT_FALSE(is_sql_name("1level"));
  EXPECT_FALSE(is_sql_name("a."));
  EXPECT_FALSE(is_sql_name(""));
  EXPECT_TRUE(is_column_source("db:rr_staff.staff_name"));
  EXPECT_FALSE(is_column_source("db:staff_name"));
  EXPECT_FALSE(is_column_source("rr_staff.staff_name"));
}

TEST(SqlCheck, knows_orders) {
  EXPECT_FALSE(sort_columns("name").empty());
  EXPECT_FALSE(sort_columns("level desc, f.name asc").empty());
  EXPECT_TRUE(sort_columns("name; drop table x").empty());
  EXPECT_TRUE(sort_columns("random()").empty());
  EXPECT_TRUE(sort_columns("").empty());
}

} // namespace parlour::script
