#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/database/sqlite/sqlite_connection.hpp"
#include "adapters/database/sqlite/sqlite_open.hpp"

namespace parlour::adapters {
namespace {

using testing::HasSubstr;
using namespace std::chrono_literals;

class SQLiteConnectionTest : public testing::Test {
protected:
  void SetUp() override {
    open({});
  }

  void open(SQLiteLimits limits) {
    db = std::make_unique<SQLiteConnection>(open_memory().value(), limits,
                                            100ms);
    write("create table shop (name text, level integer)");
    write("insert into shop values ('Starbucks Coffee', 1), ('Ya Kun', 1)");
  }

  void write(const std::string& sql) {
    const auto done = db->run(sql, {}, Access::write);
    ASSERT_TRUE(done) << done.error().message;
  }

  // The rows printed, or "Kind: message".
  std::string read(const std::string& sql, Value values = {}) {
    return shown(db->run(sql, values, Access::read));
  }

  static std::string shown(const Expected<StatementAnswer>& answer) {
    return answer ? to_string(Value(answer->rows))
                  : std::string(name_of(answer.error().kind)) + ": " +
                        answer.error().message;
  }

  std::unique_ptr<SQLiteConnection> db;
};

TEST_F(SQLiteConnectionTest, ReadsRowsWithTheirColumns) {
  auto answer =
      db->run("select name, level from shop order by 1", {}, Access::read);
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->rows, (ResultSet{{"name", "level"},
                                     {"Starbucks Coffee", 1, "Ya Kun", 1}}));
  EXPECT_EQ(answer->changes, 0);
}

TEST_F(SQLiteConnectionTest, CountsChanges) {
  auto answer = db->run("update shop set level = 2", {}, Access::write);
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->changes, 2);
  EXPECT_EQ(answer->rows, ResultSet{});
  EXPECT_EQ(db->run("create table b (c)", {}, Access::write)->changes, 0);
}

TEST_F(SQLiteConnectionTest, RefusesToWriteUnlessToldTo) {
  for (auto sql : {"insert into shop values ('x', 1)", "delete from shop",
                   "drop table shop", "update shop set level = 9",
                   "create table t (a)", "vacuum"})
    EXPECT_THAT(read(sql), HasSubstr("Refused: '")) << sql;
  EXPECT_EQ(read("select count(*) from shop where level = 1"), "[2]");
}

TEST_F(SQLiteConnectionTest, RefusesWhatIsNotForScripts) {
  for (auto sql :
       {"attach 'other.db' as other", "pragma table_info(shop)", "begin",
        "commit", "savepoint a", "select load_extension('x')", "detach main"})
    for (auto access : {Access::read, Access::write})
      EXPECT_FALSE(db->run(sql, {}, access)) << sql;
  EXPECT_THAT(
      read("attach 'o.db' as o"),
      HasSubstr("Refused: 'attach 'o.db' as o' failed: another database "
                "cannot be attached."));
}

TEST_F(SQLiteConnectionTest, RunsOneStatementOnly) {
  EXPECT_EQ(read("select 1; -- and a remark\n /* more */ ;"), "[1]");
  for (auto sql : {"select 1; select 2", "select 1; drop table shop",
                   "select 1; nonsense", "select 1; select"})
    EXPECT_THAT(read(sql), HasSubstr("one statement at a time")) << sql;
  EXPECT_THAT(read(std::string("select 1;\0 drop", 16)),
              HasSubstr("one statement at a time"));
  EXPECT_THAT(read(" -- nothing"), HasSubstr("no SQL statement"));
  EXPECT_THAT(read(""), HasSubstr("no SQL statement"));
}

TEST_F(SQLiteConnectionTest, SaysWhatIsWrongWithTheFirstWords) {
  EXPECT_EQ(read("select nam\n  from shop"),
            "Database: 'select nam from shop' failed: no such column: nam.");
  EXPECT_THAT(read("select \"nam\" from shop"), HasSubstr("no such column"));
  EXPECT_THAT(read("selekt 1"), HasSubstr("syntax error"));
  EXPECT_THAT(read("select 1 from there"), HasSubstr("no such table: there"));
}

TEST_F(SQLiteConnectionTest, BoundsItsResults) {
  open({.rows = 3, .bytes = 4096, .steps = 100'000, .statements = 2});
  const std::string numbers = "with recursive n(i) as (select 1 union all "
                              "select i + 1 from n limit ?) select i from n";
  EXPECT_EQ(read(numbers, List{3}), "[1, 2, 3]");
  EXPECT_THAT(read(numbers, List{4}), HasSubstr("Limit: '"));
  EXPECT_THAT(read("select zeroblob(5000)"), HasSubstr("Limit: '"));
  EXPECT_EQ(read(numbers, List{3}), "[1, 2, 3]");
}

TEST_F(SQLiteConnectionTest, StopsWhatTakesTooLong) {
  open({.rows = 3, .bytes = 4096, .steps = 100'000, .statements = 2});
  EXPECT_THAT(read("with recursive n(i) as (select 1 union all "
                   "select i + 1 from n) select max(i) from n"),
              HasSubstr("Limit: '"));
  EXPECT_EQ(read("select 1"), "[1]");
}

TEST_F(SQLiteConnectionTest, KeepsFewStatementsPreparedAndStaysRight) {
  open({.rows = 10, .bytes = 4096, .steps = 100'000, .statements = 2});
  for (int round = 0; round < 3; ++round)
    for (int i = 0; i < 5; ++i)
      EXPECT_EQ(read("select ? + " + std::to_string(i), List{round}),
                "[" + std::to_string(round + i) + "]");
}

TEST_F(SQLiteConnectionTest, NoticesAChangedSchemaUnderAPreparedStatement) {
  EXPECT_EQ(read("select * from shop limit 1"), "[Starbucks Coffee, 1]");
  write("alter table shop add column unit text");
  EXPECT_EQ(read("select * from shop limit 1"),
            "[Starbucks Coffee, 1, unknown]");
}

TEST_F(SQLiteConnectionTest, ForgetsBoundValues) {
  EXPECT_EQ(read("select ?", List{"secret"}), "[secret]");
  EXPECT_EQ(read("select ?", List{Value()}), "[unknown]");
}

TEST_F(SQLiteConnectionTest, KeepsOrDropsATransaction) {
  ASSERT_TRUE(db->begin());
  EXPECT_TRUE(db->in_transaction());
  write("delete from shop");
  ASSERT_TRUE(db->rollback());
  EXPECT_EQ(read("select count(*) from shop"), "[2]");
  ASSERT_TRUE(db->begin());
  write("delete from shop");
  ASSERT_TRUE(db->commit());
  EXPECT_FALSE(db->in_transaction());
  EXPECT_EQ(read("select count(*) from shop"), "[0]");
  EXPECT_FALSE(db->commit());
}

} // namespace
} // namespace parlour::adapters
