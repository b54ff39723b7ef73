#include <string>

#include <gtest/gtest.h>

#include "runtime/text/sql_scanner.hpp"

namespace parlour {
namespace {

constexpr std::string_view letters = "_wq?;.";

// A letter for the kind of each token.
std::string kinds(std::string_view sql,
                  SqlDialect dialect = SqlDialect::sqlite) {
  std::string all;
  for (SqlScanner scanner(sql, dialect); !scanner.at_end();)
    all += letters[static_cast<std::size_t>(scanner.next().kind)];
  return all;
}

SqlToken first(std::string_view sql) {
  return SqlScanner(sql).next();
}

TEST(SqlScanner, tells_words_marks_and_blanks_apart) {
  EXPECT_EQ(kinds("select a.b, 1;"), "w_w.w._w;");
  EXPECT_EQ(kinds("x=? or y=:name"), "w.?_w_w.?");
  EXPECT_EQ(kinds("a := 1"), "w_.._w");
  EXPECT_EQ(kinds(""), "");
}

TEST(SqlScanner, takes_what_is_quoted_as_one) {
  EXPECT_EQ(kinds("'a;b' \"c\" `d`"), "q_q_q");
  EXPECT_EQ(kinds("'it''s'"), "qq");
  EXPECT_EQ(first("'\\' x").text, "'\\'");
}

TEST(SqlScanner, notices_a_quotation_mark_that_does_not_end) {
  for (const auto* sql : {"'a", "\"", "`b\n", "[", "[a"})
    EXPECT_TRUE(first(sql).is_open()) << sql;
  for (const auto* sql : {"'a'", "''", "[a]", "a", "/* '"})
    EXPECT_FALSE(first(sql).is_open()) << sql;
}

TEST(SqlScanner, skips_remarks_but_not_what_mariadb_runs) {
  EXPECT_EQ(kinds("-- a; b\nselect"), "__w");
  EXPECT_EQ(kinds("# 'a\nselect"), "__w");
  EXPECT_EQ(kinds("/* ; */select"), "_w");
  EXPECT_EQ(kinds("/* ;"), "_");
  EXPECT_EQ(kinds("/*!5 a*/"), "_");
  EXPECT_EQ(kinds("/*!5 a*/", SqlDialect::mariadb), "...w_w..");
}

TEST(SqlScanner, reads_two_minus_signs_as_each_database_does) {
  EXPECT_EQ(kinds("5--1; a"), "w_");
  EXPECT_EQ(kinds("5--1; a", SqlDialect::mariadb), "w..w;_w");
  for (const auto* sql : {"--", "-- a;", "--\ta;", "--\n", "--\x01"})
    EXPECT_EQ(kinds(sql, SqlDialect::mariadb).front(), '_') << sql;
}

TEST(SqlScanner, takes_brackets_for_quotes_in_sqlite_only) {
  EXPECT_EQ(kinds("[a;'b]"), "q");
  EXPECT_EQ(kinds("[a]", SqlDialect::mariadb), ".w.");
}

TEST(FirstSqlWord, is_what_a_statement_begins_with) {
  EXPECT_EQ(first_sql_word(" -- a\n/* b */ SELECT 1"), "select");
  EXPECT_EQ(first_sql_word("(select 1)"), "(");
  EXPECT_EQ(first_sql_word("selected"), "selected");
  for (const auto* sql : {"", "  ", "; select 1", "-- select"})
    EXPECT_EQ(first_sql_word(sql), "") << sql;
}

TEST(SqlLower, leaves_all_but_ascii_alone) {
  EXPECT_EQ(sql_lower("SeLeCT_1"), "select_1");
  EXPECT_EQ(sql_lower("Ä"), "Ä");
}

} // namespace
} // namespace parlour
