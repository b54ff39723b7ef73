#include "runtime/plugin/test_host.hpp"
#include "tests/tools/parlour/application_fixture.hpp"
#include "tools/parlour/application/plugins/shipped_plugin.hpp"

namespace parlour::tools {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

constexpr const char* taxi_rules =
    "<service role='Taxi' address='http://a.com'><command name='Book'>"
    "<post url='/'/><on><event name='Booked'><param value='{/plate}'/>"
    "<param value='5'/></event></on>"
    "<sample>{\"plate\": \"SH 1\"}</sample></command>"
    "<command name='Cancel' params='plate'><delete url='/{plate}'/>"
    "<on><event name='Cancelled'/></on></command></service>";
constexpr const char* cabs =
    "<Plugins><Plugin>GrammarNLU</Plugin></Plugins>"
    "<component name='Cabs' plugin='HTTPService'>"
    "<option name='rules' value='services/taxi.xml'/></component>";

using ShippedPluginTest = ApplicationTest;

TEST_F(ShippedPluginTest, HasTheRoleOfItsRules) {
  folder_.write("taxi.xml", taxi_rules);
  auto plugin = find_plugin("HTTPService")->description;
  EXPECT_THAT(plugin.roles, IsEmpty());
  complete_description(plugin, {{"rules", "taxi.xml"}}, folder_.path());
  EXPECT_THAT(plugin.roles, ElementsAre("Taxi"));
}

TEST_F(ShippedPluginTest, StaysAsItIsIfItIsAnotherOrHasNoRules) {
  auto taxi = find_plugin("LogTaxi")->description;
  complete_description(taxi, {{"rules", "taxi.xml"}}, folder_.path());
  EXPECT_THAT(taxi.roles, ElementsAre("Taxi"));
  auto service = find_plugin("HTTPService")->description;
  complete_description(service, {{"rules", "none.xml"}}, folder_.path());
  EXPECT_THAT(service.roles, IsEmpty());
}

TEST_F(ShippedPluginTest, IsEmptyIfNothingIsKnown) {
  EXPECT_FALSE(shipped_plugin("EchoTTS").rehearse);
  EXPECT_FALSE(shipped_plugin("EchoTTS").columns);
  auto taxi = *find_plugin("LogTaxi");
  Options options = {{"file", "own.db"}};
  rehearse(taxi, options);
  EXPECT_EQ(options.count("file"), 1u);
}

// A row of the table that no plug-in goes by would never be read.
TEST_F(ShippedPluginTest, GoesByTheNameOfAPlugin) {
  for (const auto* name :
       {"SQLiteDatabase", "MySQLDatabase", "HTTPService", "MQTTDevices",
        "LogDevices", "LogWeather", "LogTraffic", "GrammarNLU", "KeywordNLU",
        "KeyPushToTalk"}) {
    EXPECT_EQ(shipped_plugin(name).name, name);
    EXPECT_TRUE(find_plugin(name)) << name;
  }
}

TEST_F(ShippedPluginTest, MayBeMissing) {
  EXPECT_EQ(shipped_plugin("SphinxASR").without,
            "turns are typed instead of spoken");
  EXPECT_EQ(shipped_plugin("LogTaxi").without, "");
  EXPECT_TRUE(is_installed("LogTaxi"));
}

TEST_F(ShippedPluginTest, HearsOrWritesAnyFile) {
  for (const auto* name : {"FileMicrophone", "FileSpeaker"}) {
    const auto open = shipped_plugin(name).for_file;
    ASSERT_TRUE(open) << name;
    const auto made = open(folder_.path() / "sound.wav");
    EXPECT_EQ(made.description.name, name);
    EXPECT_TRUE(find_plugin(name)) << name;
  }
}

TEST_F(ShippedPluginTest, MayTakeTheTerminal) {
  EXPECT_FALSE(shipped_plugin("EchoTTS").takes_terminal);
  const auto takes = shipped_plugin("KeyPushToTalk").takes_terminal;
  EXPECT_TRUE(takes({{"key", "f5"}}));
  EXPECT_TRUE(takes({{"device", ""}}));
  EXPECT_FALSE(takes({{"device", "/dev/input/event3"}}));
}

// The device is not there.
TEST_F(ShippedPluginTest, OpensNoDeviceWhereItIsRehearsed) {
  auto key = *find_plugin("KeyPushToTalk");
  Options options = {{"device", (folder_.path() / "none").string()}};
  TestHost host;
  EXPECT_FALSE(key.create()->start(host, options));
  rehearse(key, options);
  EXPECT_EQ(key.description.name, "KeyPushToTalk");
  EXPECT_TRUE(key.create()->start(host, options));
}

TEST_F(ShippedPluginTest, KeepsItsDataInItsFile) {
  const auto kept = shipped_plugin("SQLiteDatabase").kept_file;
  const auto file = [&](const Options& options) {
    return kept(options, folder_.path(), "/data").string();
  };
  EXPECT_EQ(file({{"file", "own.db"}, {"schema", "schema.sql"}}),
            "/data/own.db");
  EXPECT_EQ(file({{"schema", "schema.sql"}}), "");
  EXPECT_EQ(file({{"file", "../own.db"}, {"schema", "schema.sql"}}), "");
}

TEST_F(ShippedPluginTest, FillsItsRoleInAnApplication) {
  folder_.write("services/taxi.xml", taxi_rules);
  const auto application =
      load(cabs, "<state name='A'><Entrance>"
                 "<post module='Taxi' command='Book'>"
                 "<param expr=\"'a'\"/><param expr=\"'b'\"/>"
                 "<param expr=\"'c'\"/><param expr=\"'d'\"/></post>"
                 "<post module='Cabs' command='Cancel' param='SH 1'/>"
                 "</Entrance></state>");
  EXPECT_THAT(findings(application), Not(HasSubstr("error")));
  const auto* component = first_of_role(application.composition, "Taxi");
  ASSERT_TRUE(component);
  EXPECT_EQ(component->name, "Cabs");
}

TEST_F(ShippedPluginTest, MayBeLoadedInPlaceOfItself) {
  folder_.write("services/taxi.xml", taxi_rules);
  EXPECT_THAT(findings(load(cabs, "<state name='A'><Entrance>"
                                  "<load plugin='HTTPService' name='Cabs'/>"
                                  "</Entrance></state>")),
              Not(HasSubstr("error")));
}

TEST_F(ShippedPluginTest, ItsRulesAreCheckedWhereTheyStand) {
  folder_.write("services/taxi.xml",
                "<service role='Taxi'>\n<command name='Book'/></service>");
  EXPECT_THAT(findings(load(cabs, "<state name='A'/>")),
              AllOf(HasSubstr("services/taxi.xml:2:1: error: Book has no "
                              "request"),
                    HasSubstr("services/taxi.xml:2:1: error: Book has no "
                              "<on>")));
}

} // namespace
} // namespace parlour::tools
