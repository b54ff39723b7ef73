// Lints about whole applications: missing partners of statements, names in
// frames, repetitions.
#include "tests/script/lint/lint_case.hpp"

namespace parlour::script::lint {

INSTANTIATE_TEST_SUITE_P(
    partners, LintCase,
    testing::Values(
        Linted{"<function name='main'><pop/>\n<cancel timer='tee'/>\n"
               "<sendsocket name='feed' param='a'/>\n"
               "<querydb param='insert into t (a) values (1)'/></function>",
               "3:23 missing-partner, 4:16 missing-partner, "
               "5:19 missing-partner, 6:17 missing-partner"},
        Linted{"<function name='main'><timer name='tea' after='1s'>"
               "<cancel timer='tea'/></timer><cancel timer='{_STATE}'/>"
               "<socket name='feed' connect='a:1'/><closesocket name='feed'/>"
               "<connectdb param='' write='true'/>"
               "<querydb param='insert into t (a) values (1)'/>"
               "<querydb param='select 1'/>"
               "<push state='Welcome'/><pop/></function>",
               ""},
        // Which connection may write, counts.
        Linted{"<function name='main'><connectdb param='' write='true'/>"
               "<connectdb name='desk' param=''/>\n"
               "<querydb db='desk' param='delete from t'/></function>",
               "4:27 missing-partner"},
        Linted{"<function name='main'><connectdb name='{_STATE}' param='' "
               "write='true'/><querydb db='desk' param='delete from t'/>"
               "<timer name='{_STATE}' after='1s'/><cancel timer='tea'/>"
               "</function>",
               ""}));

INSTANTIATE_TEST_SUITE_P(
    frames, LintCase,
    testing::Values(
        Linted{"<topic name='Taxi'><slot name='Time' question='When?'/>"
               "</topic><function name='main'>\n"
               "<fire param=\"{'topic': 'Tx'}\"/>\n"
               "<fire param=\"[{'topic': 'Taxi', 'slots': {'Tim': 1}}]\"/>\n"
               "<fire param=\"{'act': 'infrm'}\"/>\n"
               "<fire param=\"{'topic': 'Taxi', 'act': 'inform', 'slots': "
               "{'Time': 1}}\"/></function>",
               "4:14 unknown-frame, 5:14 unknown-frame, 6:14 unknown-frame"},
        // Who reacts to the act may know the name.
        Linted{"<handler name='H'><messages><component><Dialogue><inform>"
               "<print param='x'/></inform></Dialogue></component></messages>"
               "</handler><function name='main'>\n"
               "<fire param=\"{'topic': 'Tx'}\"/>\n"
               "<fire param=\"{'topic': 'Tx', 'act': 'request'}\"/>"
               "</function>",
               "5:14 unknown-frame"}));

INSTANTIATE_TEST_SUITE_P(
    repetitions, LintCase,
    testing::Values(
        Linted{"<topic name='T'><examples><value>a tea</value></examples>"
               "<slot name='Size' type='Functional' question='Which?'>"
               "<cardinality type='set'><value>small</value>"
               "<value>large</value>\n<value> small </value></cardinality>"
               "</slot></topic>",
               "4:1 repeated"},
        Linted{"<repair act='help'><ask/></repair>\n"
               "<repair act='help' if='data.explanation'><ask/></repair>\n"
               "<repair act='help'><ask/></repair>",
               "5:1 repeated"},
        Linted{"<function name='main'><speak param=' '/>\n"
               "<confirm question=''/><speak param='{_STATE}'/></function>",
               "3:30 empty-text, 4:10 empty-text"}));

namespace {

std::string said_with_components(const std::string& statements) {
  test::TemporaryFolder folder;
  folder.write("settings.xml", "<settings><Scripts><Script>a.xml</Script>"
                               "</Scripts></settings>");
  folder.write("a.xml", "<dialogue><function name='main'>\n" + statements +
                            "</function></dialogue>");
  auto compiled = compile_application(folder.path(), test::platform());
  lint(compiled, {{{"Archive", {"Database"}}, {"Robot2", {"Robot"}}}, {}});
  std::string said;
  for (const auto& finding : compiled.findings.all())
    said += std::to_string(finding.place.line) + " " + finding.message + '\n';
  return said;
}

} // namespace

TEST(LintPartners, know_the_databases) {
  EXPECT_EQ(said_with_components(
                "<connectdb name='old' param='Archive'/>\n"
                "<querydb db='old' param='select 1'/>\n"
                "<querydb db='Archive' param='select 1'/>\n"
                "<querydb db='Archiv' param='select 1'/>\n"
                "<connectdb param='Nix'/><connectdb param='Database'/>"),
            "5 no <connectdb> and no database is called 'Archiv', did you mean "
            "'Archive'?\n6 no database is called 'Nix'\n");
}

TEST(LintMessages, know_components_and_what_commands_need) {
  EXPECT_EQ(
      said_with_components("<unload name='Robot'/>\n<unload name='Nix'/>\n"
                           "<post module='Robot' command='Say' param=''/>\n"
                           "<post module='Robot' command='Stop' param=''/>\n"
                           "<post module='Robot' command='Say'/>"),
      "3 no component, role or agent is called 'Nix'; name a role such "
      "as ASR, or a component of the settings\n"
      "4 'Say' of Robot needs text, and this gives nothing; write a "
      "<param expr=\"…\"/> for each\n");
}

TEST(LintMessages, know_what_a_relay_makes_of_a_command) {
  EXPECT_EQ(lints_of("<routes><relay source='ASR' command='RecognitionResult' "
                     "to='Robot' as='Sayy'/><relay source='ASR' "
                     "command='RecognitionResult' to='Robot' as='Say'/>"
                     "</routes>"),
            "3:72 unknown-command");
}

} // namespace parlour::script::lint
