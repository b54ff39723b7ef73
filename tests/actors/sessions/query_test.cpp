#include "actors/sessions/query.hpp"
#include "tests/actors/node_fixture.hpp"

namespace parlour::actors {
namespace {

using QueryTest = NodeFixture;

constexpr const char* ask_database = R"(
  <handler name="Pipeline"><messages><component>
    <ASR><RecognitionResult>
      <try>
        <querydb param="select 1" return="rows"/>
        <speak param="{rows.count} rows"/>
        <catch name="e"><speak param="{e.kind}: {e.message}"/></catch>
      </try>
    </RecognitionResult></ASR>
  </component></messages></handler>)";

TEST_F(QueryTest, BringsItsRows) {
  options.components = {
      component("db", "Database", [](auto& self, const Message& message) {
        EXPECT_EQ(message.command, "Query");
        ResultSet rows{{"a"}, {message.params.at(0), "second"}};
        self.fire_event("Result", {rows});
      })};
  start(ask_database);
  EXPECT_THAT(say({"go"}), ElementsAre("2 rows"));
}

TEST_F(QueryTest, BringsTheDatabasesError) {
  options.components = {
      component("db", "Database", [](auto& self, const Message&) {
        self.fire_event("Error", {"Database", "no such table"});
      })};
  start(ask_database);
  EXPECT_THAT(say({"go"}), ElementsAre("Database: no such table"));
}

// A <catch kind="Refused"> takes what a database refuses.
TEST_F(QueryTest, BringsTheKindOfTheDatabasesError) {
  options.components = {
      component("db", "Database", [](auto& self, const Message&) {
        self.fire_event("Error", {"Refused", "read only"});
      })};
  start(ask_database);
  EXPECT_THAT(say({"go"}), ElementsAre("Refused: read only"));
}

TEST_F(QueryTest, GivesUpInTime) {
  options.components = {component("db", "Database", [](auto&, const auto&) {})};
  start(ask_database);
  EXPECT_THAT(say({"go"}), IsEmpty());
  node->advance(9999ms);
  EXPECT_THAT(said(), IsEmpty());
  node->advance(1ms);
  EXPECT_THAT(said(), ElementsAre(HasSubstr("Timeout: ")));
}

// It may have been kept, or not.
TEST_F(QueryTest, ACommitThatIsNotAnsweredIsInDoubt) {
  options.components = {
      component("db", "Database", [](auto& self, const Message& message) {
        if (message.command != "Commit")
          self.fire_event("Result", {});
      })};
  start(R"(
    <handler name="Pipeline"><messages><component>
      <ASR><RecognitionResult>
        <try>
          <transaction><querydb param="select 1"/></transaction>
          <catch name="e"><speak param="{e.kind}"/></catch>
        </try>
      </RecognitionResult></ASR>
    </component></messages></handler>)");
  EXPECT_THAT(say({"go"}), IsEmpty());
  node->advance(10s);
  EXPECT_THAT(said(), ElementsAre("InDoubt"));
}

TEST_F(QueryTest, SaysThatNoDatabaseIsThere) {
  start(ask_database);
  EXPECT_THAT(say({"go"}), ElementsAre(HasSubstr("Offline: ")));
}

TEST_F(QueryTest, HearsOfAFailedDatabase) {
  options.components = {component("db", "Database", [](auto&, const Message&) {
    throw std::runtime_error("disk gone");
  })};
  start(ask_database);
  EXPECT_THAT(say({"go"}), ElementsAre("Database: disk gone"));
}

} // namespace
} // namespace parlour::actors
