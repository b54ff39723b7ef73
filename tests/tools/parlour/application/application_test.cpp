#include "adapters/standins/log_devices.hpp"
#include "tests/tools/parlour/application_fixture.hpp"

namespace parlour::tools {
namespace {

using testing::HasSubstr;

TEST_F(ApplicationTest, has_a_program_and_components_where_it_is_sound) {
  const auto application = load("greeter");
  ASSERT_TRUE(application.program);
  EXPECT_FALSE(application.has_errors());
  EXPECT_EQ(application.program->settings.name, "greeter");
  EXPECT_EQ(application.composition.components.size(), 2u);
}

TEST_F(ApplicationTest, has_no_program_where_it_is_broken) {
  const auto application = load("broken");
  EXPECT_FALSE(application.program);
  EXPECT_TRUE(application.has_errors());
}

TEST_F(ApplicationTest, has_no_program_where_only_a_component_is_wrong) {
  const auto application = load("bad-sql");
  EXPECT_FALSE(application.program);
  EXPECT_EQ(application.findings.size(), 1u);
}

TEST_F(ApplicationTest, sorts_what_compiler_and_components_find) {
  const auto application =
      load("<Plugins><Plugin>Nothing</Plugin></Plugins>"
           "<component name=\"Nothing\"/>",
           "<state name=\"Welcome\"><Entrance><nonsense/></Entrance></state>");
  ASSERT_GE(application.findings.size(), 2u);
  EXPECT_THAT(findings(application), testing::StartsWith("own.xml:1:"));
  EXPECT_THAT(findings(application), HasSubstr("\nsettings.xml:1:"));
}

TEST_F(ApplicationTest, is_not_written_to_by_being_loaded) {
  folder_.write("schema.sql", guest_schema);
  const auto application = load(guest_settings, guest_topic);
  EXPECT_EQ(findings(application), "");
  EXPECT_FALSE(folder_.has("own.db"));
}

TEST_F(ApplicationTest, keeps_its_database_in_memory_where_that_is_wanted) {
  const auto application = load("greeter");
  const auto options = [](const Composition& composition) {
    return first_of_role(composition, "Database")->options;
  };
  EXPECT_EQ(options(application.composition).at("file"), "greeter.db");
  EXPECT_EQ(options(rehearsed(application.composition)).count("file"), 0u);
}

TEST_F(ApplicationTest, switches_devices_on_paper_where_that_is_wanted) {
  folder_.write("devices.tsv", "device\troom\tvalue\tkind\n"
                               "lamp\thall\toff\tlight\n");
  const auto application =
      load("<Plugins><Plugin>MQTTDevices</Plugin></Plugins>"
           "<component name=\"MQTTDevices\">"
           "<option name=\"host\" value=\"127.0.0.1\"/>"
           "<option name=\"devices\" value=\"devices.tsv\"/></component>",
           "<state name=\"Welcome\"/>");
  const auto trial = rehearsed(application.composition);
  const auto& component = *first_of_role(trial, "Devices");
  EXPECT_EQ(component.name, "MQTTDevices");
  EXPECT_TRUE(
      dynamic_cast<adapters::LogDevices*>(component.factory.create().get()));
  EXPECT_EQ(component.options, (Options{{"devices", "devices.tsv"}}));
}

TEST_F(ApplicationTest, may_be_one_file) {
  folder_.write("one.xml", "<dialogue><function name=\"main\"/></dialogue>");
  const auto compiled = load_file(folder_.path() / "one.xml", process_places());
  ASSERT_TRUE(compiled.program);
  EXPECT_TRUE(compiled.program->single_file);
}

} // namespace
} // namespace parlour::tools
