#include <gmock/gmock.h>

#include "script/compiler/application/settings_reader.hpp"
#include "tests/script/snippets.hpp"

namespace parlour::script {

using testing::ElementsAre;
using testing::IsEmpty;

namespace {

std::string environment(const std::string& name) {
  return name == "PASSWORD" ? "secret" : "";
}

struct Read {
  Settings settings;
  std::vector<std::string> lines;
};

Read read(const std::string& text, const Aliases& aliases = {}) {
  Findings findings;
  findings.add_file("s.xml");
  auto settings =
      read_settings(test::tree_of("<settings>" + text + "</settings>"), aliases,
                    environment, findings);
  return {std::move(settings), test::lines_of(findings)};
}

} // namespace

TEST(SettingsReader, reads_components_in_order_of_preference) {
  const auto [settings, lines] =
      read("<Plugins><Plugin> A </Plugin><Plugin>SR_B</Plugin></Plugins>"
           "<component name='A'><option name='x' value='1'/></component>"
           "<component name='SR_B'><option name='y' value='2'/></component>"
           "<component name='Second' plugin='SR_B'/>",
           {{"SR_B", "B"}});
  EXPECT_THAT(lines, IsEmpty());
  ASSERT_EQ(settings.components.size(), 3u);
  EXPECT_EQ(settings.components[0].plugin, "A");
  EXPECT_EQ(settings.components[0].options.at("x"), "1");
  EXPECT_EQ(settings.components[1].name, "B");
  EXPECT_EQ(settings.components[1].options.at("y"), "2");
  EXPECT_EQ(settings.components[2].name, "Second");
  EXPECT_EQ(settings.components[2].plugin, "B");
}

TEST(SettingsReader, gives_nobody_the_name_of_somebody_else) {
  EXPECT_THAT(
      read("<Plugins><Plugin>System</Plugin><Plugin>A</Plugin></Plugins>"
           "<component name='ASR' plugin='A'/>"
           "<component name='A'/><component name='A'/>"
           "<agents><agent name='Timer' roles='Robot'/>"
           "<agent name='A' roles='Robot'/></agents>")
          .lines,
      ElementsAre("s.xml:1:20: error: 'System' is a source of the platform's "
                  "own; choose another name",
                  "s.xml:1:88: error: 'ASR' is the name of a role, and stands "
                  "for whoever fills it; choose another name",
                  "s.xml:1:126: error: a second <component name=\"A\">, after "
                  "the one in line 1; put both into one",
                  "s.xml:1:168: error: 'Timer' is a source of the platform's "
                  "own; choose another name",
                  "s.xml:1:203: error: there is a component 'A' already"));
}

TEST(SettingsReader, reads_how_a_component_is_kept) {
  const auto [settings, lines] =
      read("<Plugins><Plugin>A</Plugin><Plugin>B</Plugin></Plugins>"
           "<component name='A' scope='pool(3)' deadline='1.5s'"
           " host='process'/>");
  EXPECT_THAT(lines, IsEmpty());
  EXPECT_EQ(
      settings.components[0].policy,
      (ComponentPolicy{{Scope::Kind::pool, 3}, Milliseconds(1500), "process"}));
  EXPECT_EQ(settings.components[1].policy, ComponentPolicy{});
}

TEST(SettingsReader, says_which_scopes_there_are) {
  EXPECT_THAT(read("<Plugins><Plugin>A</Plugin></Plugins>"
                   "<component name='A' scope='all'/>")
                  .lines,
              ElementsAre("s.xml:1:75: error: scope=\"all\": expected node, "
                          "seat, session, inline, pool(n) with n from 1 to 64, "
                          "or loaded, alone or before one of the first four"));
}

TEST(SettingsReader, reads_times_limits_and_scripts) {
  const auto [settings, lines] =
      read("<sessions resume-after='1.5s' closes-after='1m'/>"
           "<limits instructions='5' depth='6' bytes='7KB' result='8'/>"
           "<Scripts><Script>a.xml</Script><Script>b.xml</Script></Scripts>");
  EXPECT_THAT(lines, IsEmpty());
  EXPECT_EQ(settings.sessions.resume_after.count(), 1500);
  EXPECT_EQ(settings.sessions.closes_after.count(), 60'000);
  EXPECT_EQ(settings.sessions.no_input_after, defaults::no_input_after);
  EXPECT_EQ(settings.limits.instructions, 5u);
  EXPECT_EQ(settings.limits.depth, 6u);
  EXPECT_EQ(settings.limits.bytes, 7u << 10);
  EXPECT_EQ(settings.limits.result, 8u);
  EXPECT_THAT(settings.scripts, ElementsAre("a.xml", "b.xml"));
}

TEST(SettingsReader, reads_how_a_journal_is_kept) {
  using std::chrono::hours;
  const auto [settings, lines] =
      read("<sessions journal='strict' keep='30d'/>");
  EXPECT_THAT(lines, IsEmpty());
  EXPECT_TRUE(settings.sessions.strict_journal);
  EXPECT_EQ(settings.sessions.keep_journal, hours(24 * 30));
  const auto relaxed =
      read("<sessions journal='relaxed' keep='12h'/>").settings.sessions;
  EXPECT_FALSE(relaxed.strict_journal);
  EXPECT_EQ(relaxed.keep_journal, hours(12));
  const auto usual = read("<sessions/>").settings.sessions;
  EXPECT_FALSE(usual.strict_journal);
  EXPECT_EQ(usual.keep_journal, hours(24 * 7));
}

TEST(SettingsReader, says_how_long_a_journal_can_be_kept) {
  for (const std::string keep : {"a week", "d", "-1d", "1.5d", "36501d",
                                 "9999999999h", "99999999999999999999d"}) {
    const auto [settings, lines] = read("<sessions keep='" + keep + "'/>");
    EXPECT_EQ(settings.sessions.keep_journal, std::chrono::hours(24 * 7));
    EXPECT_THAT(lines,
                ElementsAre("s.xml:1:27: error: keep=\"" + keep +
                            "\" of <sessions>: expected how long a finished "
                            "part of the journal is kept, such as 7d or 12h, "
                            "and 36500d at most"));
  }
}

TEST(SettingsReader, replaces_what_the_environment_holds_and_never_tells_it) {
  const auto [settings, lines] =
      read("<Plugins><Plugin>A</Plugin></Plugins><component name='A'>"
           "<option name='p' value='a${PASSWORD}b'/>"
           "<option name='q' value='${NONE}'/></component>");
  EXPECT_EQ(settings.components[0].options.at("p"), "asecretb");
  EXPECT_THAT(lines, ElementsAre("s.xml:1:132: warning: the environment has "
                                 "no 'NONE'; ${NONE} is empty"));
}

TEST(SettingsReader, tells_what_does_not_fit) {
  const auto lines =
      read("<Plugins><Plugin>GrammarNLU</Plugin><Plugin>GrammarNLU</Plugin>"
           "<Plugin> </Plugin></Plugins>"
           "<component name='GrammerNLU'/>"
           "<component name='GrammarNLU'><option name='a' value='${X'/>"
           "<option name='a' value='1'/></component>")
          .lines;
  EXPECT_THAT(
      lines,
      ElementsAre(
          "s.xml:1:47: error: the plug-in 'GrammarNLU' is listed twice",
          "s.xml:1:74: error: <Plugin> is empty; expected the name of a "
          "plug-in",
          "s.xml:1:102: error: 'GrammerNLU' is not in <Plugins>, did you "
          "mean 'GrammarNLU'?",
          "s.xml:1:185: error: ${ without its }",
          "s.xml:1:191: error: the option 'a' of 'GrammarNLU' is given "
          "twice"));
}

TEST(SettingsReader, reads_the_platform_s_aliases) {
  const auto aliases = read_aliases(test::tree_of(
      read_bytes(test::source_path("config/platform/aliases.xml")).value()));
  EXPECT_EQ(aliases.at("SR_WinTTS"), "EspeakTTS");
  EXPECT_EQ(aliases.at("SR_SLUR"), "GrammarNLU");
}

} // namespace parlour::script
