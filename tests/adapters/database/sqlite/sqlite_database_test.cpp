#include "adapters/database/sqlite/sqlite_database.hpp"
#include "tests/adapters/database/sqlite_fixture.hpp"

namespace parlour::adapters {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

const std::string count = "select count(*) from staff";

using SQLiteDatabaseTest = SQLiteTest;

TEST_F(SQLiteDatabaseTest, MakesAMissingFile) {
  ASSERT_TRUE(start(file_options()));
  EXPECT_TRUE(folder.has("data/staff.db"));
}

TEST_F(SQLiteDatabaseTest, DoesNotStartOnADamagedFile) {
  folder.write("data/staff.db", std::string(5000, 'x'));
  auto started = start(file_options());
  ASSERT_FALSE(started);
  EXPECT_THAT(to_string(started.error()), HasSubstr("staff.db: "));
  EXPECT_THAT(started.error().message, HasSubstr("damaged"));
  EXPECT_EQ(folder.read("data/staff.db"), std::string(5000, 'x'));
}

TEST_F(SQLiteDatabaseTest, DoesNotStartOnAFileDamagedInTheMiddle) {
  ASSERT_TRUE(start(file_options()));
  plugin->stop();
  auto bytes = folder.read("data/staff.db");
  std::fill(bytes.begin() + 4096, bytes.end(), '\x5a');
  folder.write("data/staff.db", bytes);
  auto started = start(file_options());
  ASSERT_FALSE(started);
  EXPECT_THAT(started.error().message, HasSubstr("damaged"));
}

TEST_F(SQLiteDatabaseTest, DoesNotStartWithoutASchemaForAMissingFile) {
  auto started = start({{"file", "staff.db"}});
  ASSERT_FALSE(started);
  EXPECT_THAT(started.error().message, HasSubstr("'schema'"));
  EXPECT_FALSE(start({{"file", "staff.db"}, {"schema", "missing.sql"}}));
  EXPECT_FALSE(start({{"schema", "missing.sql"}}));
  EXPECT_FALSE(start({{"busy-timeout", "soon"}}));
  EXPECT_FALSE(folder.has("data/staff.db"));
}

TEST_F(SQLiteDatabaseTest, DoesNotStartWhereNothingCanBeWritten) {
  folder.write("data", "a file where the folder should be");
  auto started = start(file_options());
  ASSERT_FALSE(started);
  EXPECT_EQ(started.error().kind, ErrorKind::file);
}

TEST_F(SQLiteDatabaseTest, LeavesNoFileWhereTheSeedFails) {
  folder.write("seed.sql", "insert into nowhere values (1)");
  auto started = start(file_options());
  ASSERT_FALSE(started);
  EXPECT_EQ(started.error().place.line, 1u);
  EXPECT_FALSE(folder.has("data/staff.db"));
}

TEST_F(SQLiteDatabaseTest, IsConnectedToItsOwnFileOnly) {
  ASSERT_TRUE(start(file_options()));
  for (const auto& wanted : {Value(), Value(""), Value("staff.db"),
                             Value(Map{{"file", "staff.db"}}), Value(Map{})})
    EXPECT_EQ(tell("Connect", {wanted}), "Result([])") << to_string(wanted);
  EXPECT_EQ(tell("Connect"), "Result([])");
  EXPECT_THAT(tell("Connect", {"/etc/passwd"}), StartsWith("Error(Refused, "));
}

TEST_F(SQLiteDatabaseTest, LetsOtherWritersWaitForTheCommit) {
  ASSERT_TRUE(start(file_options()));
  tell("Begin");
  write("delete from staff");
  const std::string insert = "insert into staff (name) values ('Ong')";
  EXPECT_EQ(write(insert, {}, "s2"), "0 events");
  EXPECT_EQ(tell("Begin", {}, "s3"), "0 events");
  send("s1", "Commit");
  EXPECT_THAT(host.take_events(),
              ElementsAre("Result([])", "Result([], 1)", "Result([])"));
  EXPECT_EQ(query(count, {}, "s3"), "Result([1])");
  EXPECT_EQ(tell("Commit", {}, "s3"), "Result([])");
}

TEST_F(SQLiteDatabaseTest, LetsReadersWaitTooInMemory) {
  ASSERT_TRUE(start(options()));
  tell("Begin");
  write("delete from staff");
  EXPECT_EQ(query(count, {}, "s2"), "0 events");
  send("s1", "Rollback");
  EXPECT_THAT(host.take_events(), ElementsAre("Result([])", "Result([3])"));
}

TEST_F(SQLiteDatabaseTest, DoesNotLetThemWaitForEver) {
  ASSERT_TRUE(start(file_options()));
  tell("Begin");
  EXPECT_EQ(tell("Begin", {}, "s2"), "0 events");
  host.advance(2s);
  EXPECT_THAT(host.take_events(),
              ElementsAre(StartsWith("Error(Timeout, Another conversation")));
  EXPECT_EQ(tell("Commit"), "Result([])");
}

TEST_F(SQLiteDatabaseTest, TakesAnOldTransactionAway) {
  ASSERT_TRUE(start(file_options()));
  tell("Begin");
  write("delete from staff");
  host.advance(30s);
  EXPECT_EQ(host.logs.size(), 1u);
  EXPECT_THAT(write("delete from staff"), HasSubstr("rolled back"));
  EXPECT_THAT(tell("Commit"), HasSubstr("rolled back"));
  EXPECT_EQ(query(count), "Result([3])");
}

TEST_F(SQLiteDatabaseTest, DoesNotTakeALaterTransactionAway) {
  ASSERT_TRUE(start(file_options()));
  tell("Begin");
  tell("Commit");
  host.advance(20s);
  tell("Begin");
  host.advance(20s);
  EXPECT_EQ(tell("Commit"), "Result([])");
}

// A delay that outlives its purpose would be waited for.
TEST_F(SQLiteDatabaseTest, LeavesNoDelaysBehind) {
  ASSERT_TRUE(start(file_options()));
  tell("Begin");
  send("s2", "Begin");
  EXPECT_EQ(host.pending(), 2u);
  send("s1", "Commit");
  EXPECT_EQ(host.pending(), 1u); // of s2, which goes on
  send("s2", "Rollback");
  EXPECT_EQ(host.pending(), 0u);
  send("s1", "Begin");
  send("s2", "Begin");
  plugin->stop();
  EXPECT_EQ(host.pending(), 0u);
}

TEST_F(SQLiteDatabaseTest, TellsWhoWaitsWhenItStops) {
  ASSERT_TRUE(start(file_options()));
  tell("Begin");
  write("delete from staff");
  send("s2", "Begin");
  plugin->stop();
  EXPECT_THAT(host.take_events(), ElementsAre(StartsWith("Error(Offline, ")));
  EXPECT_THAT(query(count), StartsWith("Error(Offline, "));
  host.advance(1min);
  EXPECT_TRUE(host.events.empty());
}

TEST_F(SQLiteDatabaseTest, DescribesItself) {
  const auto description = sqlite_database_factory().description;
  EXPECT_EQ(description.name, "SQLiteDatabase");
  EXPECT_THAT(description.roles, ElementsAre("Database"));
  EXPECT_TRUE(description.blocks);
  EXPECT_FALSE(description.is_inline);
}

// -- the values of columns ----------------------------------------------------

TEST_F(SQLiteDatabaseTest, TellsNewValuesOfAColumnBehindTheAnswer) {
  ASSERT_TRUE(start(with(options(), "columns", "db:staff.name")));
  send("s1", "Query",
       {"insert into staff (name) values ('Ada Wong')", List{}, true});
  EXPECT_THAT(host.take_events(),
              ElementsAre("Result([], 1)",
                          "ValuesChanged(db:staff.name, [Ada Wong, Dr. "
                          "Jeffery Ho, Lim, Tan Ah Kow])"));
  write("delete from staff where name <> 'Lim'");
  send("s1", "Query", {"update staff set level = 1", List{}, true});
  EXPECT_THAT(host.take_events(), ElementsAre("Result([], 1)"));
}

TEST_F(SQLiteDatabaseTest, TellsTheValuesOfATriggerAndOfATransactionAtItsEnd) {
  folder.write("schema.sql",
               "create table staff (id integer primary key, name text, level "
               "integer); create table log (name text); create trigger t after "
               "insert on staff begin insert into log values (new.name); end;");
  ASSERT_TRUE(start(with(options(), "columns", "db:Main.log.name")));
  tell("Begin");
  send("s1", "Query",
       {"insert into staff (name) values ('Ada')", List{}, true});
  EXPECT_THAT(host.take_events(), ElementsAre("Result([], 2)"));
  send("s1", "Commit");
  EXPECT_THAT(
      host.take_events(),
      ElementsAre("Result([])",
                  "ValuesChanged(db:Main.log.name, [Ada, Dr. Jeffery Ho, Lim, "
                  "Tan Ah Kow])"));
  tell("Begin");
  write("delete from log");
  send("s1", "Rollback");
  EXPECT_THAT(host.take_events(), ElementsAre("Result([])"));
}

TEST_F(SQLiteDatabaseTest, KeepsTheValuesOfAColumnThatCannotBeRead) {
  ASSERT_TRUE(start(with(options(), "columns", "db:staff.name")));
  write("alter table staff rename column name to surname");
  write("delete from staff");
  EXPECT_THAT(host.logs, ElementsAre(HasSubstr("name")));
  write("insert into staff (surname) values ('Lim')");
  EXPECT_EQ(host.logs.size(), 1u);
}

} // namespace
} // namespace parlour::adapters
