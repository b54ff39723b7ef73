// SQLite and MariaDB give the same answers to the same statements.
#include "adapters/database/sqlite/sqlite_database.hpp"
#include "tests/adapters/database/mariadb_fixture.hpp"

namespace parlour::adapters {
namespace {

struct Asked {
  const char* sql;
  Value values;
};

// What answers alike, to the letter.
const std::vector<Asked>& answered_alike() {
  static const std::vector<Asked> all{
      {"select id, name, level from staff order by id", {}},
      {"select name as who from staff where level > ? order by who", List{1}},
      {"select name from staff where level is null", {}},
      {"select count(*), sum(level), min(name), max(name) from staff", {}},
      {"select avg(level) from staff", {}},
      {"select 'it''s' || ' ' || name from staff where id = 1", {}},
      {"select \"name\" from staff where id = :id", Map{{"id", 2}}},
      {"select count(*) from staff where name = 'lim'", {}},
      {"select count(*) from staff where name = 'Lim '", {}},
      {"select ?, ?, ?, ?", List{true, -7, "text", Value()}},
      {"select ?, ? + 1", List{2.5, 1.5}},
      {"select '\\', 'a\\nb'", {}},
      {"select true, false, 1 = 1, 1 = 2, not 1, null is null", {}},
      {"select case when level is null then 'none' else level end from staff "
       "order by id",
       {}},
      {"select coalesce(level, 0) from staff order by id", {}},
      {"select distinct level from staff where level is not null", {}},
      {"select name from staff order by name limit 2 offset 1", {}},
      {"select upper(name), lower(name), substr(name, 1, 3) from staff "
       "where id = 3",
       {}},
      {"select a.name from staff as a join staff as b on a.level = b.level "
       "and a.id < b.id",
       {}},
      {"select level, count(*) as n from staff group by level "
       "having n > 1 order by level",
       {}},
      {"select name from staff where level in (?, ?) order by id",
       List{13, 14}},
      {"select name from staff where name like 'Tan%'", {}},
      {"select '2026-11-21' < '2026-11-22', '10:30' between '09:00' and "
       "'17:00'",
       {}},
      {"with some as (select * from staff) select count(*) from some", {}},
      {"values (1, 'a'), (2, 'b')", {}},
      {"select 'Zo\xc3\xab', length('abc')", {}},
      {"select x'00ff'", {}},
      {"select 1 as a from staff where 1 = 2", {}}};
  return all;
}

// The same errors, whatever the words.
const std::vector<Asked>& refused_alike() {
  static const std::vector<Asked> all{{"select nam from staff", {}},
                                      {"select \"nam\" from staff", {}},
                                      {"select 1 from nowhere", {}},
                                      {"", {}},
                                      {"select 1; select 2", {}},
                                      {"delete from staff", {}},
                                      {"begin", {}},
                                      {"select ?", {}},
                                      {"select ?", List{1, 2}},
                                      {"select ?", List{Value(List{})}},
                                      {"select ?", "one"},
                                      {"select :a", Map{{"b", 1}}},
                                      {"select :a", Map{{"a", 1}, {"b", 1}}},
                                      {"select ?", List{"\xff"}}};
  return all;
}

class MariaDBAndSQLiteTest : public MariaDBTest {
protected:
  void SetUp() override {
    MariaDBTest::SetUp();
    if (IsSkipped())
      return;
    ASSERT_TRUE(start(options()));
    other = sqlite_database_factory().create();
    ASSERT_TRUE(
        other->start(host, {{"schema", "schema.sql"}, {"seed", "seed.sql"}}));
  }

  std::string ask_other(const std::string& command, std::vector<Value> params) {
    std::swap(plugin, other);
    auto answer = tell(command, std::move(params));
    std::swap(plugin, other);
    return answer;
  }
  // With the names of its columns.
  static std::string shown(const Message& event) {
    const auto* rows =
        event.params.empty() ? nullptr : event.params[0].if_result();
    std::string text = event.command;
    if (rows)
      for (const auto& column : rows->columns)
        text += " " + column;
    return text;
  }
  static std::string kind_of(const std::string& answer) {
    return answer.starts_with("Error(") ? answer.substr(0, answer.find(','))
                                        : answer;
  }

  std::unique_ptr<IPlugin> other;
};

TEST_F(MariaDBAndSQLiteTest, AnswerAlike) {
  for (const auto& [sql, values] : answered_alike())
    EXPECT_EQ(query(sql, values), ask_other("Query", {sql, values})) << sql;
}

TEST_F(MariaDBAndSQLiteTest, NameTheirColumnsAlike) {
  send("s1", "Query", {"select id, name as who, count(*) from staff"});
  std::swap(plugin, other);
  send("s1", "Query", {"select id, name as who, count(*) from staff"});
  std::swap(plugin, other);
  ASSERT_EQ(host.events.size(), 2u);
  EXPECT_EQ(shown(host.events[0]), "Result id who count(*)");
  EXPECT_EQ(shown(host.events[1]), shown(host.events[0]));
}

TEST_F(MariaDBAndSQLiteTest, RefuseAlike) {
  for (const auto& [sql, values] : refused_alike()) {
    const auto answer = query(sql, values);
    EXPECT_THAT(answer, testing::StartsWith("Error(")) << sql;
    EXPECT_EQ(kind_of(answer), kind_of(ask_other("Query", {sql, values})))
        << sql;
  }
}

TEST_F(MariaDBAndSQLiteTest, WriteAlike) {
  const std::vector<std::vector<Value>> writes{
      {"insert into staff (name, level) values (?, ?)", List{"Ong", 4}, true},
      {"insert into staff (name, level) values (?, ?)", List{"Ong", 4}, true},
      {"insert into staff (name) values (null)", List{}, true},
      {"update staff set level = 13 where level = 13", List{}, true},
      {"update staff set level = ? where name = ?", List{Value(), "Ong"}, true},
      {"delete from staff where level is null", List{}, true},
      {"delete from staff where id = 99", List{}, true},
      {"insert into staff (name) values ('Ng') returning name", List{}, true}};
  for (const auto& params : writes) {
    EXPECT_EQ(kind_of(tell("Query", params)),
              kind_of(ask_other("Query", params)))
        << to_string(params[0]);
    const std::string all = "select name, level from staff order by name";
    EXPECT_EQ(query(all), ask_other("Query", {all}));
  }
}

} // namespace
} // namespace parlour::adapters
