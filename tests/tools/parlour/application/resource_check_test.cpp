#include "tests/tools/parlour/application_fixture.hpp"

namespace parlour::tools {
namespace {

using testing::HasSubstr;
using testing::MatchesRegex;

class ResourceCheckTest : public ApplicationTest {
protected:
  std::string wrong(const std::string& dialogue) const {
    const auto application = load(guest_settings, dialogue);
    EXPECT_EQ(application.program == nullptr, application.has_errors());
    return findings(application);
  }
};

TEST_F(ResourceCheckTest, is_content_where_columns_and_grammars_are_there) {
  folder_.write("schema.sql", guest_schema);
  EXPECT_EQ(wrong(guest_topic), "");
}

TEST_F(ResourceCheckTest, misses_a_file_of_sql) {
  EXPECT_THAT(wrong(guest_topic), HasSubstr("schema.sql"));
  EXPECT_THAT(wrong(guest_topic), HasSubstr(": error: "));
}

TEST_F(ResourceCheckTest, tells_once_that_an_option_is_of_another_type) {
  folder_.write("schema.sql", guest_schema);
  std::string settings = guest_settings;
  const std::string schema = "<option name=\"schema\"";
  settings.insert(settings.find(schema),
                  "<option name=\"max-rows\" value=\"many\"/>");
  EXPECT_THAT(findings(load(settings, guest_topic)),
              MatchesRegex("[^\n]*: error: SQLiteDatabase: the option "
                           "'max-rows' takes a whole number, not 'many'"
                           "[^\n]*\n"));
}

TEST_F(ResourceCheckTest, places_a_mistake_in_sql) {
  folder_.write("schema.sql", "create table guest (name text);\n\n"
                              "insert into gest values ('Ada');\n");
  EXPECT_THAT(wrong(guest_topic),
              MatchesRegex("schema.sql:3:[0-9]+: error: [^\n]*gest[^\n]*\n"));
}

TEST_F(ResourceCheckTest, misses_a_column) {
  folder_.write("schema.sql", "create table guest (surname text);\n");
  EXPECT_THAT(wrong(guest_topic),
              MatchesRegex("[^\n]*: error: [^\n]*name[^\n]*\n"));
}

TEST_F(ResourceCheckTest, tells_of_a_column_where_it_is_named) {
  folder_.write("schema.sql", "create table guest (surname text);\n");
  std::string topic = guest_topic;
  const std::string column = "db:guest.name";
  topic.replace(topic.find(column), column.size(),
                "db:SQLiteDatabase.guest.name");
  EXPECT_THAT(wrong(topic),
              MatchesRegex("own.xml:[0-9:]+ error: The column 'db:"
                           "SQLiteDatabase.guest.name' [^\n]*\n"));
}

TEST_F(ResourceCheckTest, places_a_mistake_in_a_grammar) {
  folder_.write("schema.sql", guest_schema);
  folder_.write("desk.jsgf", "#JSGF V1.0;\ngrammar desk;\n"
                             "public <desk> = (hello | good <nobody>;\n");
  EXPECT_THAT(wrong(std::string(guest_topic) +
                    "<grammar name=\"desk\" file=\"desk.jsgf\"/>"),
              HasSubstr("desk.jsgf:3:"));
}

TEST_F(ResourceCheckTest, places_a_mistake_in_a_file_of_examples) {
  folder_.write("schema.sql", guest_schema);
  folder_.write("more.tsv", "Visit\tI am here\nVist\tI want to see her\n");
  const auto with = [&](const std::string& name, const std::string& value) {
    return findings(load(std::string(guest_settings) +
                             "<component name=\"GrammarNLU\"><option name=\"" +
                             name + "\" value=\"" + value + "\"/></component>",
                         guest_topic));
  };
  EXPECT_EQ(with("examples", "more.tsv"),
            "more.tsv:2:1: error: there is no topic 'Vist', did you mean "
            "'Visit'?\n");
  EXPECT_THAT(with("examples", "../more.tsv"), HasSubstr("leaves its folder"));
  for (const auto* threshold : {"2", "high"})
    EXPECT_THAT(with("threshold", threshold),
                MatchesRegex("settings.xml:[0-9:]+ error: GrammarNLU: the "
                             "option 'threshold' takes a number[^\n]*\n"));
}

TEST_F(ResourceCheckTest, places_a_mistake_in_a_list_of_devices) {
  const std::string settings =
      "<Plugins><Plugin>MQTTDevices</Plugin></Plugins>"
      "<component name=\"MQTTDevices\">"
      "<option name=\"devices\" value=\"devices.tsv\"/></component>";
  folder_.write("devices.tsv", "device\troom\tkind\nlamp\thall\tlight\n");
  EXPECT_EQ(findings(load(settings, "")), "");
  folder_.write("devices.tsv", "device\troom\tkind\nlamp\thall\tlantern\n");
  EXPECT_THAT(findings(load(settings, "")),
              MatchesRegex("devices.tsv:2:[0-9]+: error: [^\n]*'lantern'\n"));
}

TEST_F(ResourceCheckTest, misses_a_file_that_an_option_names) {
  const std::string settings =
      "<Plugins><Plugin>LogWeather</Plugin></Plugins>"
      "<component name=\"LogWeather\">"
      "<option name=\"reports\" value=\"weather.tsv\"/></component>";
  EXPECT_THAT(findings(load(settings, "")),
              HasSubstr("warning: LogWeather: there is no file 'weather.tsv', "
                        "which the option 'reports' names"));
  folder_.write("weather.tsv", "");
  EXPECT_EQ(findings(load(settings, "")), "");
}

} // namespace
} // namespace parlour::tools
