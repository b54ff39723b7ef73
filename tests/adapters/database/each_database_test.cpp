// Tests that run for each database by itself.
#include <algorithm>
#include <type_traits>

#include "runtime/plugin/conformance.hpp"
#include "tests/adapters/database/mariadb_fixture.hpp"
#include "tests/adapters/database/sqlite_fixture.hpp"

namespace parlour::adapters {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

const std::string everybody = "select count(*) from staff";

class DatabaseNames {
public:
  template <class Fixture>
  static std::string GetName(int) {
    return std::is_same_v<Fixture, SQLiteTest> ? "SQLite" : "MariaDB";
  }
};

template <class Fixture>
class EachDatabaseTest : public Fixture {};

// Those of MariaDB share a server with the other tests of MariaDB.
using Databases = testing::Types<SQLiteTest, MariaDBTest>;
TYPED_TEST_SUITE(EachDatabaseTest, Databases, DatabaseNames);

TYPED_TEST(EachDatabaseTest, Conforms) {
  const TestOptions terms{this->options(), Milliseconds(30'000),
                          this->host.data, this->host.application};
  EXPECT_THAT(conformance_errors(this->factory(), terms), IsEmpty());
}

TYPED_TEST(EachDatabaseTest, DescribesWhatAllHaveAlike) {
  const auto described = this->factory().description.options;
  for (const auto& [name, type] :
       {std::pair("schema", OptionType::text),
        std::pair("seed", OptionType::text),
        std::pair("busy-timeout", OptionType::duration),
        std::pair("transaction-timeout", OptionType::duration),
        std::pair("max-rows", OptionType::integer),
        std::pair("max-bytes", OptionType::integer)}) {
    const auto found =
        std::ranges::find(described, name, &OptionDescription::name);
    ASSERT_NE(found, described.end()) << name;
    EXPECT_EQ(found->type, type) << name;
  }
}

TYPED_TEST(EachDatabaseTest, AnswersQueries) {
  ASSERT_TRUE(this->start(this->options()));
  EXPECT_EQ(this->query("select name from staff where level = ? order by id",
                        List{Value(13)}),
            "Result([Dr. Jeffery Ho, Lim])");
  EXPECT_EQ(this->query("select level from staff where name = :n",
                        Map{{"n", "Tan Ah Kow"}}),
            "Result([unknown])");
}

TYPED_TEST(EachDatabaseTest, AnswersWithSessionAndCorrelation) {
  ASSERT_TRUE(this->start(this->options()));
  this->send("s8", "Query", {everybody});
  const auto& events = this->host.events;
  ASSERT_EQ(events.size(), 1u);
  EXPECT_EQ(events[0].session, "s8");
  EXPECT_EQ(events[0].correlation, 7u);
  ASSERT_EQ(events[0].params.size(), 1u);
  EXPECT_TRUE(events[0].params[0].if_result());
}

// Engine rule 1.9.
TYPED_TEST(EachDatabaseTest, TellsNewValuesOfItsColumns) {
  ASSERT_TRUE(
      this->start(this->with(this->options(), "columns", "db:staff.name")));
  this->send("s1", "Query",
             {"insert into staff (name) values ('Ada Wong')", List{}, true});
  EXPECT_THAT(this->host.wait_for_events(2),
              ElementsAre("Result([], 1)",
                          "ValuesChanged(db:staff.name, [Ada Wong, Dr. "
                          "Jeffery Ho, Lim, Tan Ah Kow])"));
  this->send("s1", "Query", {"update staff set level = 3", List{}, true});
  this->send("s1", "Query", {everybody});
  EXPECT_THAT(this->host.wait_for_events(2),
              ElementsAre(StartsWith("Result([], "), "Result([4])"));
}

TYPED_TEST(EachDatabaseTest, WritesWhenToldTo) {
  ASSERT_TRUE(this->start(this->options()));
  EXPECT_EQ(this->write("insert into staff (name) values (?)", List{"Ong"}),
            "Result([], 1)");
  EXPECT_EQ(this->query(everybody), "Result([4])");
  EXPECT_THAT(this->query("delete from staff"), StartsWith("Error(Refused, "));
  EXPECT_EQ(this->query(everybody), "Result([4])");
}

TYPED_TEST(EachDatabaseTest, TakesValuesOfOtherTypesNextTime) {
  ASSERT_TRUE(this->start(this->options()));
  const std::string longer(1'000, 'x');
  for (const auto& value :
       {Value(1), Value("one"), Value(), Value(longer), Value("a"), Value(2.5),
        Value(), Value(-3), Value(std::string(40'000, 'y')), Value(true)})
    EXPECT_EQ(this->query("select ?", List{value}),
              "Result([" + (value.if_boolean() ? "1" : value.text()) + "])");
}

TYPED_TEST(EachDatabaseTest, AnswersErrorsByKind) {
  ASSERT_TRUE(this->start(this->options()));
  EXPECT_THAT(this->query("select nam from staff"),
              StartsWith("Error(Database, "));
  EXPECT_THAT(this->query("select ?", List{Value(List{})}),
              StartsWith("Error(Type, "));
  EXPECT_THAT(this->query("select 1; select 2"), StartsWith("Error(Refused, "));
  EXPECT_THAT(this->write("insert into staff (name) values ('Lim')"),
              StartsWith("Error(Database, 'insert into staff (name) values "
                         "('Lim')' failed: "));
  EXPECT_THAT(this->tell("Query"), StartsWith("Error(Type, "));
  EXPECT_THAT(this->tell("Query", {5}), StartsWith("Error(Type, "));
  EXPECT_THAT(this->tell("Truncate"), HasSubstr("the command 'Truncate'"));
}

TYPED_TEST(EachDatabaseTest, KeepsWhatIsWritten) {
  ASSERT_TRUE(this->start(this->options_for("kept")));
  EXPECT_EQ(this->query(everybody), "Result([3])");
  this->write("insert into staff (name) values ('Ong')");
  this->plugin->stop();
  EXPECT_THAT(this->query(everybody), StartsWith("Error(Offline, "));
  ASSERT_TRUE(this->start(this->options_for("kept")));
  EXPECT_EQ(this->query(everybody), "Result([4])");
}

TYPED_TEST(EachDatabaseTest, SharesNoCopy) {
  ASSERT_TRUE(this->start(this->options()));
  this->write("delete from staff");
  const auto first = std::move(this->plugin);
  ASSERT_TRUE(this->start(this->options()));
  EXPECT_EQ(this->query(everybody), "Result([3])");
}

TYPED_TEST(EachDatabaseTest, KeepsATransactionApartFromOthers) {
  ASSERT_TRUE(this->start(this->options_for("apart")));
  EXPECT_EQ(this->tell("Begin"), "Result([])");
  EXPECT_EQ(this->write("delete from staff"), "Result([], 3)");
  EXPECT_EQ(this->query(everybody), "Result([0])");
  EXPECT_EQ(this->query(everybody, {}, "s2"), "Result([3])");
  EXPECT_EQ(this->tell("Rollback"), "Result([])");
  EXPECT_EQ(this->query(everybody), "Result([3])");
}

TYPED_TEST(EachDatabaseTest, RefusesTransactionsOutOfOrder) {
  ASSERT_TRUE(this->start(this->options()));
  EXPECT_THAT(this->tell("Commit"), StartsWith("Error(Database, Commit: "));
  EXPECT_THAT(this->tell("Rollback"), StartsWith("Error(Database, Rollback: "));
  this->tell("Begin");
  EXPECT_THAT(this->tell("Begin"), HasSubstr("in a transaction already"));
}

TYPED_TEST(EachDatabaseTest, RollsBackWhenItStops) {
  ASSERT_TRUE(this->start(this->options_for("stopped")));
  this->tell("Begin");
  this->write("delete from staff");
  this->plugin->stop();
  ASSERT_TRUE(this->start(this->options_for("stopped")));
  EXPECT_EQ(this->query(everybody), "Result([3])");
}

TYPED_TEST(EachDatabaseTest, KnowsItsColumnsAfterTheTableHasChanged) {
  ASSERT_TRUE(this->start(this->options()));
  const std::string all = "select * from staff where name = 'Lim'";
  EXPECT_EQ(this->query(all), "Result([3, Lim, 13])");
  this->write("alter table staff add column unit varchar(9)");
  this->send("s1", "Query", {all});
  ASSERT_EQ(this->host.events.size(), 1u);
  const auto* rows = this->host.events[0].params.at(0).if_result();
  ASSERT_TRUE(rows);
  EXPECT_THAT(rows->columns, ElementsAre("id", "name", "level", "unit"));
}

} // namespace
} // namespace parlour::adapters
