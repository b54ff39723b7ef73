// Each pass of the lint: what it reports, and what it does not.
#include "tests/script/lint/lint_case.hpp"

namespace parlour::script::lint {

TEST_P(LintCase, finds_what_is_there_and_nothing_else) {
  EXPECT_EQ(lints_of(GetParam().dialogue), GetParam().said);
}

INSTANTIATE_TEST_SUITE_P(
    routes, LintCase,
    testing::Values(
        Linted{"<routes><relay source='NLU' command='FrameInfo' to='NLU'/>"
               "</routes>",
               "3:9 endless-relay"},
        Linted{"<routes><relay source='NLU' command='*' to='TTS'/>\n"
               "<relay source='TTS' command='Finished' to='NLU'/></routes>",
               "3:9 endless-relay, 4:1 endless-relay"},
        Linted{"<routes><relay source='Record' command='BufferFull' "
               "to='Microphone*'/></routes>",
               "3:9 endless-relay"},
        // A condition may end it, and another command is another matter.
        Linted{"<routes><relay source='NLU' command='FrameInfo' to='NLU' "
               "if='_LPARAM1'/></routes>",
               ""},
        Linted{"<routes><relay source='NLU' command='FrameInfo' to='NLU' "
               "as='DoNLU'/></routes>",
               ""},
        Linted{"<routes><relay source='NLU' command='FrameInfo' to='TTS' "
               "as='Speak'/><relay source='TTS' command='Finished' to='NLU'/>"
               "</routes>",
               ""}));

INSTANTIATE_TEST_SUITE_P(
    states, LintCase,
    testing::Values(
        Linted{"", ""}, // one state alone is where the topics live
        Linted{"<state name='B'/>", "3:1 unreachable-state"},
        Linted{"<state name='B'><Entrance><transit state='C'/></Entrance>"
               "</state><state name='C'><Entrance><print param='x'/>"
               "</Entrance></state>",
               "3:1 unreachable-state, 3:66 unreachable-state, 3:66 "
               "state-without-exit"},
        Linted{"<state name='B'><Entrance><end/></Entrance></state><handler "
               "name='h'><messages><on source='*' event='*'><transit "
               "state='B'/></on></messages></handler>",
               ""},
        Linted{"<state name='B'><Entrance><transit state='C'/></Entrance>"
               "</state><state name='C'><Entrance><transit state='B'/>"
               "</Entrance></state>",
               "3:1 unreachable-state, 3:1 endless-loop, 3:66 "
               "unreachable-state"},
        Linted{"<state name='B'/><function name='main'><transit "
               "state='{_LPARAM1}'/></function>",
               ""}));

// Only an application's components are known.
TEST(LintRoles, that_nothing_fills_are_told) {
  test::TemporaryFolder folder;
  folder.write("settings.xml", "<settings><Scripts><Script>a.xml</Script>"
                               "</Scripts></settings>");
  folder.write("a.xml",
               "<dialogue><handler name='h'><messages><component>\n"
               "<Record><BufferFull><post module='ASR' "
               "command='Finish'/></BufferFull></Record>\n"
               "<Session><Started><post module='Taxi' command='Book'/>\n"
               "<post module='NLU' command='DoNLU'/></Started></Session>"
               "</component></messages></handler></dialogue>");
  auto compiled = compile_application(folder.path(), test::platform());
  lint(compiled, {{{"Understanding", {"NLU"}}}, {}});
  ASSERT_EQ(compiled.findings.all().size(), 1u);
  const auto& finding = compiled.findings.all()[0];
  EXPECT_EQ(finding.name, "unfilled-role");
  EXPECT_EQ(finding.place.line, 3u);
}

TEST(LintAllowances, take_warnings_out) {
  const auto loop = in_main("\n<while cond='true'/>");
  EXPECT_EQ(lints_of(loop), "4:14 endless-loop");
  for (const auto* comment :
       {"\n<!-- check: allow endless-loop -->\n<while cond='true'/>",
        "\n<while cond='true'/> <!-- check: allow endless-loop -->",
        "\n<!-- check: allow unread-variable, endless-loop -->\n"
        "<while cond='true'/>",
        "<!-- check: allow endless-loop in this file -->\n\n\n"
        "<while cond='true'/>"})
    EXPECT_EQ(lints_of(in_main(comment)), "") << comment;
}

TEST(LintAllowances, allow_no_more_than_they_say) {
  EXPECT_EQ(lints_of(in_main("\n<!-- check: allow endless-loop -->\n\n"
                             "<while cond='true'/>")),
            "6:14 endless-loop");
  EXPECT_EQ(lints_of(in_main("\n<!-- check: allow endles-loop -->\n"
                             "<while cond='true'/>")),
            "4:19 unknown-lint, 5:14 endless-loop");
}

} // namespace parlour::script::lint
