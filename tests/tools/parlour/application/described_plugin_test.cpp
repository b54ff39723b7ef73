#include "tests/tools/parlour/application_fixture.hpp"
#include "tools/parlour/application/described_plugin.hpp"

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

using DescribedPlugin = ApplicationTest;

TEST_F(DescribedPlugin, HasTheRoleOfItsRules) {
  folder_.write("taxi.xml", taxi_rules);
  auto plugin = find_plugin("HTTPService")->description;
  EXPECT_THAT(plugin.roles, IsEmpty());
  complete_description(plugin, {{"rules", "taxi.xml"}}, folder_.path());
  EXPECT_THAT(plugin.roles, ElementsAre("Taxi"));
}

TEST_F(DescribedPlugin, StaysAsItIsIfItIsAnotherOrHasNoRules) {
  auto taxi = find_plugin("LogTaxi")->description;
  complete_description(taxi, {{"rules", "taxi.xml"}}, folder_.path());
  EXPECT_THAT(taxi.roles, ElementsAre("Taxi"));
  auto service = find_plugin("HTTPService")->description;
  complete_description(service, {{"rules", "none.xml"}}, folder_.path());
  EXPECT_THAT(service.roles, IsEmpty());
}

TEST_F(DescribedPlugin, FillsItsRoleInAnApplication) {
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

TEST_F(DescribedPlugin, MayBeLoadedInPlaceOfItself) {
  folder_.write("services/taxi.xml", taxi_rules);
  EXPECT_THAT(findings(load(cabs, "<state name='A'><Entrance>"
                                  "<load plugin='HTTPService' name='Cabs'/>"
                                  "</Entrance></state>")),
              Not(HasSubstr("error")));
}

TEST_F(DescribedPlugin, ItsRulesAreCheckedWhereTheyStand) {
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
