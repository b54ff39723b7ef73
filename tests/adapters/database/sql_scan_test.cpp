#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/database/sql_scan.hpp"

namespace parlour::adapters {
namespace {

using testing::ElementsAre;

TEST(ScanSql, FindsPlaceholders) {
  const auto scanned = scan_sql("Select :a, ? from t where b=:long_name");
  EXPECT_EQ(scanned.text, "Select ?, ? from t where b=?");
  EXPECT_THAT(scanned.names, ElementsAre("a", "", "long_name"));
  EXPECT_EQ(scanned.first_word, "select");
  EXPECT_FALSE(scanned.more);
}

TEST(ScanSql, FindsNoneInQuotesAndRemarks) {
  for (auto sql : {"select ':a ? it''s'", "select \":a\"", "select `?`",
                   "select 1 -- :a ?", "select 1 # ?\n", "select /* ? */ 1",
                   "select '\\' -- ?", "select a := 1"})
    EXPECT_TRUE(scan_sql(sql).names.empty()) << sql;
}

TEST(ScanSql, FindsThemBehindTwoMinusSigns) {
  EXPECT_THAT(scan_sql("select 5--:a").names, ElementsAre("a"));
  EXPECT_TRUE(scan_sql("select 5--1; delete from t").more);
}

TEST(ScanSql, FindsTheFirstWord) {
  EXPECT_EQ(scan_sql(" -- a\n/* b */ # c\n DELETE from t").first_word,
            "delete");
  EXPECT_EQ(scan_sql("(select 1)").first_word, "(");
  EXPECT_EQ(scan_sql("/*!50000 set a = 1 */").first_word, "/");
  for (auto sql : {"", "  ", "-- select", "/* select", ";"})
    EXPECT_EQ(scan_sql(sql).first_word, "") << sql;
}

TEST(ScanSql, NoticesASecondStatement) {
  for (auto sql : {"select 1;", "select 1; -- end", "select ';'", "select 1;;"})
    EXPECT_FALSE(scan_sql(sql).more) << sql;
  for (auto sql :
       {"select 1; select 2", "select 1;x", "; select 1", "select ''; 'a'"})
    EXPECT_TRUE(scan_sql(sql).more) << sql;
}

TEST(ScanSql, EndsWithWhatIsNotClosed) {
  for (auto sql : {"select 'a", "select \"", "select `", "/*", "--", ":", "'"})
    EXPECT_FALSE(scan_sql(sql).more) << sql;
}

TEST(SplitSql, KnowsTheLines) {
  const auto parts = split_sql("-- a; b\ncreate table t (a /*! x */);\n\n"
                               "insert into t values (';');\n-- end\n");
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_EQ(parts[0].line, 2u);
  EXPECT_EQ(parts[1].text, "insert into t values (';')");
  EXPECT_EQ(parts[1].line, 4u);
  EXPECT_EQ(split_sql("insert into t values (5--1); select 1").size(), 2u);
  EXPECT_TRUE(split_sql(" ;; -- nothing\n").empty());
}

} // namespace
} // namespace parlour::adapters
