#include "tests/tools/parlour/application_fixture.hpp"

namespace parlour::tools {
namespace {

using testing::HasSubstr;

using ColumnReaderTest = ApplicationTest;

TEST_F(ColumnReaderTest, reads_the_first_database) {
  const auto greeter = load("greeter");
  const auto read =
      column_reader(rehearsed(greeter.composition), greeter.folder, "");
  EXPECT_THAT(read("db:guest.name").value(), testing::ElementsAre("Ada"));
  EXPECT_FALSE(read("db:guest.age"));
  const auto none = column_reader(Composition{}, greeter.folder, "");
  EXPECT_THAT(none("db:guest.name").error().message,
              HasSubstr("has no database"));
}

TEST_F(ColumnReaderTest, reads_the_database_that_is_named) {
  folder_.write("now.sql", "create table guest (name text);\n"
                           "insert into guest values ('Ada');");
  folder_.write("then.sql", "create table guest (name text);\n"
                            "insert into guest values ('Ben');");
  const auto own =
      load("<Plugins><Plugin>GrammarNLU</Plugin><Plugin>SQLiteDatabase</Plugin>"
           "</Plugins><component name=\"SQLiteDatabase\">"
           "<option name=\"schema\" value=\"now.sql\"/></component>"
           "<component name=\"Archive\" plugin=\"SQLiteDatabase\">"
           "<option name=\"schema\" value=\"then.sql\"/></component>",
           "<topic name=\"Visit\">"
           "<slot name=\"Guest\" type=\"Functional\" question=\"Who?\">"
           "<cardinality type=\"query\" source=\"db:Archive.guest.name\"/>"
           "</slot><examples><value>[Ben](Guest)</value></examples></topic>");
  EXPECT_EQ(findings(own), "");
  const auto read = column_reader(own.composition, own.folder, "");
  EXPECT_THAT(read("db:guest.name").value(), testing::ElementsAre("Ada"));
  EXPECT_THAT(read("db:Archive.guest.name").value(),
              testing::ElementsAre("Ben"));
  EXPECT_THAT(read("db:SQLiteDatabase.guest.name").value(),
              testing::ElementsAre("Ada"));
  EXPECT_THAT(read("db:Archiv.guest.name").error().message,
              testing::AllOf(HasSubstr("there is no database 'Archiv'"),
                             HasSubstr("did you mean 'Archive'")));
}

TEST_F(ColumnReaderTest, names_the_columns_of_slots_and_grammars) {
  UnderstandingModel model;
  model.topics = {{"Visit",
                   false,
                   {{"Host", "query", {}, "db:staff.name"},
                    {"Guest", "query", {}, "db:staff.name"}},
                   {}}};
  model.grammars = {{"g",
                     "public <a> = @db:Archive.guest.name | <@db:staff.room> "
                     "| @db:staff.name;",
                     {}}};
  EXPECT_THAT(column_names(model),
              testing::ElementsAre("db:staff.name", "db:Archive.guest.name",
                                   "db:staff.room"));
}

TEST_F(ColumnReaderTest, knows_whose_columns_they_are) {
  const auto greeter = load("greeter");
  const auto owners =
      column_owners(greeter.composition,
                    {"db:a.b", "db:Archive.c.d", "db:SQLiteDatabase.e.f"});
  EXPECT_EQ(owners("SQLiteDatabase"), "db:a.b, db:SQLiteDatabase.e.f");
  EXPECT_EQ(owners("Archive"), "db:Archive.c.d");
  EXPECT_EQ(owners("Other"), "");
}

} // namespace
} // namespace parlour::tools
