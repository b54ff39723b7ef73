#include <gtest/gtest.h>

#include "runtime/text/sql_check.hpp"

namespace parlour {

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

TEST(SqlCheck, does_not_read_remarks) {
  EXPECT_EQ(wrong_select("select 1 /* it's; more */"), "");
  EXPECT_EQ(wrong_select("-- it's\nselect 1; -- end"), "");
  EXPECT_EQ(wrong_select("-- select 1"), "expected one select statement");
}

// What ends the first statement of one database is a comment or a quotation in
// the other one.
TEST(SqlCheck, refuses_what_one_of_the_databases_reads_as_two) {
  for (const auto* sql :
       {"select 1 --1; delete from b", "select 1 --'\n; delete from b --'",
        "select 1 /*! ; delete from b */", "select 1 /*!'*/; delete from b --'",
        "select [']; delete from b; --']"})
    EXPECT_NE(wrong_select(sql), "") << sql;
  EXPECT_EQ(wrong_select("select 1 --1; delete from b"),
            "expected one statement only; there is more behind the ';' (as "
            "MariaDB reads it: a comment begins with '--' and a blank, and "
            "'/*!' begins none)");
  for (const auto* sql : {"select 5--1", "select [a b] from c", "select 1 --"})
    EXPECT_EQ(wrong_select(sql), "") << sql;
}

TEST(SqlCheck, knows_what_only_looks) {
  for (const char* sql :
       {"select 1", "\n -- which\nSELECT name from staff;",
        "with x as (select 1 as a) select a from x",
        "select 'delete', \"update\", replace(name, 'into', '') from staff",
        "select updated, for_whom from deleted_items"})
    EXPECT_TRUE(only_looks(sql)) << sql;
}

TEST(SqlCheck, takes_what_writes_locks_or_is_in_doubt_for_a_deed) {
  for (const char* sql :
       {"", "insert into staff values (1)", "explain select 1",
        "select * from staff into outfile '/tmp/staff'",
        "select * from staff INTO/**/dumpfile '/tmp/staff'",
        "select a into @a from t", "select * from staff for update",
        "select * from staff lock in share mode",
        "with x as (delete from staff returning *) select * from x",
        "with x as (select 1) delete from staff",
        "with x as (select 1) insert into staff select * from x",
        "select 1; delete from staff", "select next value for numbers",
        "select nextval(numbers)", "select get_lock('a', 1)",
        "select 1 /*! into outfile '/tmp/one' */", "select 'open"})
    EXPECT_FALSE(only_looks(sql)) << sql;
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
  const auto columns = sort_columns("level  desc, f.name asc,\nasc");
  ASSERT_EQ(columns.size(), 3u);
  EXPECT_TRUE(columns[0].falling);
  EXPECT_EQ(columns[1].name, "f.name");
  EXPECT_FALSE(columns[1].falling);
  EXPECT_EQ(columns[2].name, "asc");
  EXPECT_TRUE(sort_columns("level DESC").empty());
  EXPECT_TRUE(sort_columns("name; drop table x").empty());
  EXPECT_TRUE(sort_columns("random()").empty());
  EXPECT_TRUE(sort_columns("").empty());
}

} // namespace parlour
