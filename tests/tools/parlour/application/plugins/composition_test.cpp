#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tools/parlour/application/plugins/composition.hpp"

namespace parlour::tools {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

Settings settings_with(std::vector<ComponentSettings> components) {
  Settings settings;
  settings.components = std::move(components);
  return settings;
}

ComponentSettings component(std::string plugin, Options options = {}) {
  return {plugin, plugin, std::move(options), {"settings.xml", 3, 5}};
}

Composition compose(const Settings& settings) {
  Catalogue plugins;
  return tools::compose(settings, plugins);
}

Composition compose(const Settings& settings, const PluginFactory& plugin) {
  const std::vector<PluginFactory> table = {plugin};
  Catalogue plugins({}, table);
  return tools::compose(settings, plugins);
}

std::vector<std::string> findings_of(ComponentSettings asked) {
  std::vector<std::string> texts;
  for (const auto& finding : compose(settings_with({asked})).findings)
    texts.push_back(script::to_string(finding));
  return texts;
}

TEST(Composition, chooses_what_the_settings_name_in_their_order) {
  const auto made = compose(
      settings_with({component("LogTaxi"), component("SQLiteDatabase")}));
  EXPECT_THAT(made.findings, IsEmpty());
  ASSERT_EQ(made.components.size(), 2u);
  EXPECT_EQ(made.components[0].factory.description.name, "LogTaxi");
  EXPECT_EQ(first_of_role(made, "Database")->name, "SQLiteDatabase");
  EXPECT_EQ(first_of_role(made, "ASR"), nullptr);
}

TEST(Composition, keeps_instances_of_one_plugin_apart) {
  const auto made = compose(settings_with(
      {{"Front", "LogTaxi", {}, {}}, {"Back", "LogTaxi", {}, {}}}));
  ASSERT_EQ(made.components.size(), 2u);
  EXPECT_EQ(made.components[1].name, "Back");
  EXPECT_THAT(names_of_role(made, "Taxi"), ElementsAre("Back", "Front"));
  EXPECT_THAT(names_of_role(made, "ASR"), IsEmpty());
}

TEST(Composition, names_the_nearest_plugin) {
  EXPECT_THAT(findings_of(component("SQLiteDatabse")),
              ElementsAre("settings.xml:3:5: error: there is no plug-in "
                          "'SQLiteDatabse', did you mean 'SQLiteDatabase'?"));
}

TEST(Composition, names_the_nearest_option) {
  EXPECT_THAT(findings_of(component("SQLiteDatabase", {{"fil", "x.db"}})),
              ElementsAre("settings.xml:3:5: error: SQLiteDatabase has no "
                          "option 'fil', did you mean "
                          "'file'?"));
}

TEST(Composition, misses_options_that_are_required) {
  PluginFactory factory;
  factory.description.name = "Needy";
  factory.description.options = {{"place", "", "where it is", true}};
  const auto made = compose(settings_with({component("Needy")}), factory);
  ASSERT_EQ(made.findings.size(), 1u);
  EXPECT_EQ(made.findings[0].message,
            "Needy: the option 'place' is missing: where it is");
}

TEST(Composition, misses_values_that_fit_their_options) {
  PluginFactory factory;
  factory.description.name = "Paced";
  factory.description.options = {
      {"pace", "2s", "how long it takes", false, OptionType::duration}};
  EXPECT_THAT(
      compose(settings_with({component("Paced", {{"pace", "1s"}})}), factory)
          .findings,
      IsEmpty());
  const auto made =
      compose(settings_with({component("Paced", {{"pace", "soon"}})}), factory);
  ASSERT_EQ(made.findings.size(), 1u);
  EXPECT_EQ(made.findings[0].message,
            "Paced: the option 'pace' takes a time such as 200ms, 1.5s or 2m, "
            "not 'soon': how long it takes");
}

TEST(Composition, has_deadlines_that_are_kept_in_time) {
  auto slow = component("LogTaxi");
  EXPECT_EQ(compose(settings_with({slow})).components[0].policy.deadline,
            Milliseconds(5'000)); // half of request-timeout
  slow.policy.deadline = Milliseconds(10'000);
  EXPECT_THAT(
      findings_of(slow),
      ElementsAre("settings.xml:3:5: warning: LogTaxi: its deadline is not "
                  "shorter than request-timeout: a request ends before the "
                  "component is given up"));
  auto direct = component("PhraseNLG");
  direct.policy.deadline = Milliseconds(100);
  EXPECT_THAT(findings_of(direct),
              ElementsAre("settings.xml:3:5: error: PhraseNLG: it is asked in "
                          "the conversation's own turn, where nobody can give "
                          "up a call that hangs; for a deadline, say "
                          "scope=\"node\""));
  direct.policy.scope.kind = Scope::Kind::node;
  EXPECT_THAT(findings_of(direct), IsEmpty());
}

TEST(Composition, passes_over_what_is_not_loaded_yet) {
  auto spare = component("LogTaxi");
  spare.policy.scope.instances = 0;
  const auto made =
      compose(settings_with({spare, {"Second", "LogTaxi", {}, {}}}));
  EXPECT_EQ(made.components.size(), 2u); // it is checked all the same
  EXPECT_EQ(first_of_role(made, "Taxi")->name, "Second");
}

TEST(Composition, runs_without_the_voice_that_it_does_not_have) {
  const std::vector<PluginFactory> none;
  Catalogue without({}, none);
  const auto made =
      tools::compose(settings_with({component("EspeakTTS")}), without);
  EXPECT_THAT(made.findings, IsEmpty());
  EXPECT_THAT(made.components, IsEmpty());
  EXPECT_THAT(made.notices,
              ElementsAre("EspeakTTS is not available in this build: text is "
                          "shown instead of spoken"));
}

// -- remote agents ------------------------------------------------------------

Settings settings_with_agent(AgentSettings agent) {
  Settings settings = settings_with({component("LogRobot")});
  agent.place = {"settings.xml", 4, 5};
  settings.agents.agents.push_back(std::move(agent));
  return settings;
}

std::vector<std::string> findings_of_agent(AgentSettings agent) {
  std::vector<std::string> texts;
  for (const auto& finding :
       compose(settings_with_agent(std::move(agent))).findings)
    texts.push_back(script::to_string(finding));
  return texts;
}

TEST(Composition, prefers_an_agent_and_has_its_stand_in) {
  const auto made =
      compose(settings_with_agent({.name = "Porter",
                                   .stand_in = "LogRobot",
                                   .options = {{"place", "hall"}}}));
  EXPECT_THAT(made.findings, IsEmpty());
  ASSERT_EQ(made.components.size(), 2u);
  const auto& porter = made.components[0];
  ASSERT_TRUE(porter.agent);
  EXPECT_THAT(porter.agent->roles, ElementsAre("Robot"));
  EXPECT_EQ(porter.name, "Porter");
  EXPECT_EQ(porter.factory.description.name, "LogRobot");
  EXPECT_EQ(porter.options.at("place"), "hall");
  EXPECT_FALSE(made.components[1].agent);
  EXPECT_EQ(first_of_role(made, "Robot")->name, "Porter");
}

TEST(Composition, has_an_agent_without_a_stand_in) {
  const auto made =
      compose(settings_with_agent({.name = "Porter", .roles = {"Robot"}}));
  EXPECT_THAT(made.findings, IsEmpty());
  EXPECT_EQ(made.components[0].factory.description.name, "RemoteAgent");
  EXPECT_THAT(made.components[0].factory.description.roles,
              ElementsAre("Robot"));
}

TEST(Composition, checks_an_agents_stand_in) {
  EXPECT_THAT(
      findings_of_agent({.name = "Porter", .stand_in = "LogRobt"}),
      ElementsAre(testing::HasSubstr("settings.xml:4:5: error: there is no "
                                     "plug-in 'LogRobt'")));
  EXPECT_THAT(findings_of_agent({.name = "Porter",
                                 .roles = {"Robot", "Taxi"},
                                 .stand_in = "LogRobot"}),
              ElementsAre("settings.xml:4:5: error: Porter: its stand-in "
                          "LogRobot cannot fill the role Taxi"));
  EXPECT_THAT(findings_of_agent({.name = "Porter",
                                 .stand_in = "LogRobot",
                                 .options = {{"wheels", "4"}}}),
              ElementsAre(testing::HasSubstr("wheels")));
  EXPECT_THAT(
      findings_of_agent(
          {.name = "Porter", .roles = {"Robot"}, .options = {{"a", "1"}}}),
      ElementsAre("settings.xml:4:5: error: Porter: options are those of a "
                  "stand-in, and the agent has none"));
}

} // namespace
} // namespace parlour::tools
