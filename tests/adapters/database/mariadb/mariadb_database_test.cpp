#include "adapters/database/mariadb/mariadb_database.hpp"
#include "tests/adapters/database/mariadb_fixture.hpp"

namespace parlour::adapters {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;
using testing::UnorderedElementsAre;

const std::string everybody = "select count(*) from staff";

using MariaDBDatabaseTest = MariaDBTest;

TEST_F(MariaDBDatabaseTest, DropsItsCopyInTheEnd) {
  ASSERT_TRUE(start(options()));
  const std::string copies = "select count(*) from information_schema.schemata "
                             "where schema_name like 'dropped%'";
  {
    const auto first = std::move(plugin);
    ASSERT_TRUE(start(with(options(), "database", "dropped")));
    EXPECT_EQ(query(copies), "Result([1])");
    plugin->stop();
    plugin = nullptr;
  }
  ASSERT_TRUE(start(options()));
  EXPECT_EQ(query(copies), "Result([0])");
}

TEST_F(MariaDBDatabaseTest, DoesNotStartWithAWrongSchemaOrSettings) {
  folder.write("seed.sql", "\ninsert into nowhere values (1)");
  auto started = start(options());
  ASSERT_FALSE(started);
  EXPECT_EQ(started.error().place.line, 2u);
  EXPECT_THAT(started.error().message, HasSubstr("nowhere"));
  EXPECT_FALSE(start(with(options(), "schema", "missing.sql")));
  EXPECT_FALSE(start(with(options(), "busy-timeout", "soon")));
  auto missing = options_for("not_there");
  missing.erase("schema");
  missing.erase("seed");
  started = start(missing);
  ASSERT_FALSE(started);
  EXPECT_THAT(started.error().message, HasSubstr("not_there"));
}

TEST_F(MariaDBDatabaseTest, IsConnectedToItsOwnDatabaseOnly) {
  ASSERT_TRUE(start(options_for("own")));
  for (const auto& wanted :
       {Value(), Value(""), Value(name_of("own")),
        Value(Map{{"database", name_of("own")}}), Value(Map{})})
    EXPECT_EQ(tell("Connect", {wanted}), "Result([])") << to_string(wanted);
  EXPECT_THAT(tell("Connect", {"mysql"}), StartsWith("Error(Refused, "));
}

TEST_F(MariaDBDatabaseTest, LetsOtherWritersWaitForTheCommit) {
  ASSERT_TRUE(start(with(options(), "one-by-one", "false")));
  EXPECT_EQ(tell("Begin"), "Result([])");
  EXPECT_EQ(write("update staff set level = 1"), "Result([], 3)");
  send("s2", "Query", {"update staff set level = level + 1", List{}, true});
  send("s1", "Commit");
  EXPECT_THAT(host.wait_for_events(2),
              UnorderedElementsAre("Result([])", "Result([], 3)"));
  EXPECT_EQ(query("select distinct level from staff"), "Result([2])");
}

TEST_F(MariaDBDatabaseTest, DoesNotLetThemWaitForEver) {
  ASSERT_TRUE(start(with(options(), "busy-timeout", "1s")));
  tell("Begin");
  write("delete from staff");
  EXPECT_THAT(write("delete from staff", {}, "s2"),
              StartsWith("Error(Timeout, 'delete from staff' failed: Lock"));
  EXPECT_EQ(tell("Commit"), "Result([])");
}

TEST_F(MariaDBDatabaseTest, TakesAnOldTransactionAway) {
  ASSERT_TRUE(start(with(options(), "transaction-timeout", "20ms")));
  tell("Begin");
  ASSERT_TRUE(host.wait_for_log());
  EXPECT_THAT(write("delete from staff"), HasSubstr("rolled back"));
  EXPECT_THAT(tell("Commit"), HasSubstr("rolled back"));
  EXPECT_THAT(tell("Commit"), HasSubstr("no transaction"));
  EXPECT_EQ(query(everybody), "Result([3])");
}

TEST_F(MariaDBDatabaseTest, RefusesInATransactionWhatItCannotUndo) {
  ASSERT_TRUE(start(options()));
  tell("Begin");
  EXPECT_THAT(write("create table t (a integer)"),
              StartsWith("Error(Refused, "));
}

// Two that each want what the other has: one of them has to begin again.
TEST_F(MariaDBDatabaseTest, EndsADeadlock) {
  ASSERT_TRUE(start(with(options(), "one-by-one", "false")));
  tell("Begin", {}, "s1");
  tell("Begin", {}, "s2");
  write("update staff set level = 1 where id = 1", {}, "s1");
  write("update staff set level = 2 where id = 2", {}, "s2");
  const std::string all = "update staff set level = 3 where id = ?";
  send("s1", "Query", {all, List{2}, true});
  send("s2", "Query", {all, List{1}, true});
  EXPECT_THAT(
      host.wait_for_events(2),
      UnorderedElementsAre("Result([], 1)", StartsWith("Error(Database, ")));
  const auto first = tell("Commit", {}, "s1");
  const auto second = tell("Commit", {}, "s2");
  EXPECT_THAT((std::vector{first, second}),
              UnorderedElementsAre("Result([])", HasSubstr("rolled back")));
}

TEST_F(MariaDBDatabaseTest, DescribesItself) {
  const auto description = mysql_database_factory().description;
  EXPECT_EQ(description.name, "MySQLDatabase");
  EXPECT_THAT(description.roles, ElementsAre("Database"));
  EXPECT_FALSE(description.is_inline);
}

} // namespace
} // namespace parlour::adapters
