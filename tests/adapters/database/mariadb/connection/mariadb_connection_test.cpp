#include "adapters/database/mariadb/connection/mariadb_connection.hpp"
#include "tests/adapters/database/mariadb_fixture.hpp"

namespace parlour::adapters {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

using MariaDBConnectionTest = MariaDBTest;

TEST_F(MariaDBConnectionTest, RefusesToWriteUnlessToldTo) {
  ASSERT_TRUE(start(options()));
  for (auto sql : {"insert into staff (name) values ('x')", "delete from staff",
                   "drop table staff", "update staff set level = 9",
                   "create table t (a integer)", "alter table staff add a text",
                   "truncate staff", "create sequence s"})
    EXPECT_THAT(query(sql), StartsWith("Error(Refused, '")) << sql;
  EXPECT_EQ(write("create sequence s"), "Result([], 0)");
  EXPECT_THAT(query("select next value for s"), StartsWith("Error(Refused, "));
}

TEST_F(MariaDBConnectionTest, RefusesWhatIsNotForScripts) {
  ASSERT_TRUE(start(options()));
  for (auto sql : {"set sql_mode = ''", "begin", "commit", "savepoint a",
                   "use mysql", "lock tables staff write", "flush tables",
                   "grant all on *.* to x", "/*!50000 set @a = 1 */",
                   "start transaction", "call p()", "shutdown", "kill 1"}) {
    EXPECT_THAT(query(sql), StartsWith("Error(Refused, ")) << sql;
    EXPECT_THAT(write(sql), StartsWith("Error(Refused, ")) << sql;
  }
}

TEST_F(MariaDBConnectionTest, RunsOneStatementOnly) {
  ASSERT_TRUE(start(options()));
  EXPECT_EQ(query("select 1; -- and a remark\n /* more */ ;"), "Result([1])");
  for (auto sql : {"select 1; select 2", "select 1; drop table staff"})
    EXPECT_THAT(query(sql), HasSubstr("one statement at a time")) << sql;
  EXPECT_THAT(query(" -- nothing"), HasSubstr("no SQL statement"));
}

// What only a later version runs is a remark.
TEST_F(MariaDBConnectionTest, RefusesPlaceholdersThatMariaDBSeesOtherwise) {
  ASSERT_TRUE(start(options()));
  EXPECT_THAT(query("select 5 /*!999999 , ? */", List{1}),
              StartsWith("Error(Refused, "));
}

// MariaDB takes `--` for a remark only where a blank follows.
TEST_F(MariaDBConnectionTest, ReadsTwoMinusSignsAsMariaDBDoes) {
  ASSERT_TRUE(start(options()));
  EXPECT_EQ(query("select 5--?", List{1}), "Result([6])");
  EXPECT_EQ(query("select 5 -- ?"), "Result([5])");
}

TEST_F(MariaDBConnectionTest, BoundsItsResults) {
  ASSERT_TRUE(
      start(with(with(options(), "max-rows", "3"), "max-bytes", "4096")));
  const std::string numbers = "with recursive n(i) as (select 1 union all "
                              "select i + 1 from n where i < ?) "
                              "select i from n";
  EXPECT_EQ(query(numbers, List{3}), "Result([1, 2, 3])");
  EXPECT_THAT(query(numbers, List{900}), StartsWith("Error(Limit, 'with"));
  EXPECT_THAT(query(numbers + " limit 100", List{100}),
              StartsWith("Error(Limit, 'with"));
  EXPECT_THAT(query("select repeat('x', 5000)"), StartsWith("Error(Limit, "));
  EXPECT_EQ(query("select 'it goes on'"), "Result([it goes on])");
}

TEST_F(MariaDBConnectionTest, ReadsTextsOfEveryLength) {
  ASSERT_TRUE(start(options()));
  EXPECT_EQ(query("select char_length(?)", List{std::string(70'000, 'x')}),
            "Result([70000])");
  // Short, long, short in one result: the place grows in between.
  EXPECT_EQ(
      query("select repeat('ab', n) from (select 1 as n union all "
            "select 300 union all select 2) as t"),
      "Result([ab, " +
          [] {
            std::string text;
            for (int i = 0; i < 300; ++i)
              text += "ab";
            return text;
          }() +
          ", abab])");
}

TEST_F(MariaDBConnectionTest, KeepsFewStatementsPreparedAndStaysRight) {
  ASSERT_TRUE(start(options()));
  for (int round = 0; round < 3; ++round)
    for (int i = 0; i < 70; ++i)
      EXPECT_EQ(query("select ? + " + std::to_string(i), List{round}),
                "Result([" + std::to_string(round + i) + "])");
}

TEST_F(MariaDBConnectionTest, NoticesAChangedSchemaUnderAPreparedStatement) {
  ASSERT_TRUE(start(with(options(), "connections", "1")));
  const std::string lim = "select * from staff where name = 'Lim'";
  EXPECT_EQ(query(lim), "Result([3, Lim, 13])");
  EXPECT_EQ(write("alter table staff add column unit varchar(9)"),
            "Result([], 0)");
  EXPECT_EQ(query(lim), "Result([3, Lim, 13, unknown])");
}

TEST_F(MariaDBConnectionTest, SpeaksUtf8) {
  ASSERT_TRUE(start(options()));
  const std::string name = "Zoë 王小明 😀";
  EXPECT_EQ(write("insert into staff (name) values (?)", List{name}),
            "Result([], 1)");
  EXPECT_EQ(query("select name, char_length(name) from staff where name = ?",
                  List{name}),
            "Result([" + name + ", 9])");
  EXPECT_THAT(query("select ?", List{"\xff"}), HasSubstr("is not valid UTF-8"));
}

} // namespace
} // namespace parlour::adapters
