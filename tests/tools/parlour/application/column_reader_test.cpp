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

} // namespace
} // namespace parlour::tools
