#include <cstdlib>

#include <gmock/gmock.h>

#include "script/compiler/compiler.hpp"
#include "tests/script/snippets.hpp"

namespace parlour::script {

using testing::ElementsAre;
using testing::IsEmpty;

namespace {

const std::string paper = "tests/fixtures/paper";

std::string bytes(const std::string& name) {
  return read_bytes(test::source_path(name)).value_or("missing: " + name);
}

std::vector<std::string> check_paper(const std::string& name) {
  const auto folder = test::source_path(paper);
  return test::lines_of(
      compile_file(folder + "/" + name, test::platform()).findings, folder);
}

Compiled compile_paper(const std::string& name) {
  return compile_application(test::source_path(paper + "/" + name),
                             test::platform());
}

} // namespace

TEST(Paper, fig4_names_plug_ins_that_are_mapped_to_ours) {
  const auto compiled = compile_file(
      test::source_path(paper + "/fig4-plugins.xml"), test::platform());
  ASSERT_TRUE(compiled.program);
  EXPECT_THAT(compiled.findings.all(), IsEmpty());
  std::vector<std::string> plugins;
  for (const auto& component : compiled.program->settings.components)
    plugins.push_back(component.plugin);
  EXPECT_THAT(plugins,
              ElementsAre("EspeakTTS", "WebRtcEnhancement", "SphinxASR",
                          "GrammarNLU", "PhraseNLG", "MySQLDatabase"));
}

TEST(Paper, fig5_alone_reports_exactly_the_name_that_is_not_printed) {
  const auto lines = check_paper("fig5-pipeline.xml");
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_THAT(lines[0], testing::StartsWith("fig5-pipeline.xml:13:"));
  EXPECT_THAT(lines[0], testing::HasSubstr("NameVariationMap"));
}

TEST(Paper, the_other_listings_compile_by_themselves) {
  for (const auto* name : {"post-microphone.xml", "post-nlu.xml",
                           "querydb-staff.xml", "transit-if.xml"})
    EXPECT_THAT(check_paper(name), IsEmpty()) << name;
}

TEST(Paper, fig7_alone_warns_of_its_sql_only) {
  const auto lines = check_paper("fig7-slot.xml");
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_THAT(lines[0], testing::HasSubstr("fig7-slot.xml:14:"));
  EXPECT_THAT(lines[0], testing::HasSubstr(": warning: "));
}

TEST(Paper, its_small_applications_compile) {
  for (const auto* name : {"app", "staff"}) {
    const auto compiled = compile_paper(name);
    EXPECT_TRUE(compiled.program) << name;
    EXPECT_THAT(test::lines_of(compiled.findings), IsEmpty()) << name;
  }
}

TEST(Paper, the_applications_hold_the_listings_as_printed) {
  for (const auto* name : {"fig5-pipeline.xml", "fig7-slot.xml", "post-nlu.xml",
                           "transit-if.xml", "post-microphone.xml"})
    EXPECT_EQ(bytes(paper + "/" + name), bytes(paper + "/app/" + name));
  EXPECT_EQ(bytes(paper + "/querydb-staff.xml"),
            bytes(paper + "/staff/querydb-staff.xml"));
}

TEST(Paper, fig5_becomes_a_handler_with_its_five_reactions) {
  const auto program = compile_paper("app").program;
  ASSERT_TRUE(program);
  ASSERT_EQ(program->handlers.size(), 3u);
  const auto& handler = program->handlers[0];
  EXPECT_EQ(handler.name, "CommonHandler");
  std::vector<std::string> reactions;
  for (const auto& reaction : handler.reactions)
    reactions.push_back(reaction.source + "." + reaction.event);
  EXPECT_THAT(reactions,
              ElementsAre("Record.BufferFull", "ASR.RecognitionResult",
                          "NLU.FrameInfo", "NLU.NoResult", "NLG.Speak"));
}

TEST(Paper, fig7_becomes_a_slot) {
  const auto program = compile_paper("app").program;
  ASSERT_TRUE(program);
  const auto& slot = program->topics.at(0).slots.at(0);
  EXPECT_EQ(slot.name, "FacilityName");
  EXPECT_TRUE(slot.functional);
  EXPECT_EQ(slot.cardinality.type, "set");
  EXPECT_EQ(slot.cardinality.values.size(), 4u);
  EXPECT_NE(slot.question, no_code);
  EXPECT_NE(slot.filled, no_code);
}

TEST(Compiler, gives_no_program_where_there_are_errors) {
  const auto outcome = test::compile_declarations("<state/>");
  EXPECT_FALSE(outcome.program);
  EXPECT_EQ(outcome.lines.size(), 1u);
}

TEST(Compiler, brings_the_platform_s_phrases_behind_the_application_s) {
  const auto outcome = test::compile_declarations(
      "<phrases><phrase act='greet'>Hi</phrase></phrases>");
  ASSERT_TRUE(outcome.program) << outcome.lines.at(0);
  ASSERT_GT(outcome.program->phrases.size(), 10u);
  EXPECT_EQ(outcome.program->phrases[0].act, "greet");
  EXPECT_THAT(outcome.program->settings.libraries,
              ElementsAre("phrases-en", "repair"));
}

TEST(Compiler, tells_what_cannot_be_read) {
  test::TemporaryFolder folder;
  const auto path = folder.path().string();
  EXPECT_THAT(
      test::lines_of(compile_application(path, test::platform()).findings,
                     path),
      ElementsAre("settings.xml: error: this file cannot be read: No such "
                  "file or directory"));
  EXPECT_THAT(
      test::lines_of(compile_file(path + "/x.xml", test::platform()).findings,
                     path),
      ElementsAre("x.xml: error: this file cannot be read: No such "
                  "file or directory"));
}

// A few things in settings.xml, and all else as without it.
TEST(Compiler, completes_settings_without_scripts) {
  test::TemporaryFolder folder;
  folder.write("settings.xml",
               "<settings><sessions no-input-after='5s'/></settings>");
  folder.write("a.xml", "<dialogue><state name='First'/></dialogue>");
  const auto compiled = compile_application(folder.path(), test::platform());
  ASSERT_TRUE(compiled.program);
  const auto& settings = compiled.program->settings;
  EXPECT_EQ(settings.start, "First");
  EXPECT_EQ(settings.sessions.no_input_after, Milliseconds(5000));
  EXPECT_THAT(settings.scripts, ElementsAre("a.xml"));
  EXPECT_EQ(settings.components.size(), 2u);
}

TEST(Compiler, needs_a_script) {
  test::TemporaryFolder folder;
  for (const auto* settings :
       {"<settings/>", "<settings><Scripts/></settings>"}) {
    folder.write("settings.xml", settings);
    EXPECT_FALSE(compile_application(folder.path(), test::platform()).program)
        << settings;
  }
}

TEST(Compiler, needs_no_settings) {
  test::TemporaryFolder folder;
  folder.write("b.xml", "<dialogue><state name='Second'/></dialogue>");
  folder.write("a.xml", "<dialogue><state name='First'/></dialogue>");
  const auto compiled = compile_application(folder.path(), test::platform());
  ASSERT_TRUE(compiled.program);
  EXPECT_EQ(compiled.program->settings.start, "First");
  EXPECT_EQ(compiled.program->states.size(), 2u);
  EXPECT_THAT(compiled.program->settings.scripts,
              ElementsAre("a.xml", "b.xml"));
  EXPECT_EQ(compiled.program->settings.components.size(), 2u);
}

TEST(Compiler, finds_what_is_wrong_in_all_files_at_once) {
  test::TemporaryFolder folder;
  folder.write("settings.xml",
               "<settings start='Welcom'>\n<Scripts>\n<Script>a.xml</Script>\n"
               "<Script>b.xml</Script>\n</Scripts>\n</settings>");
  folder.write("a.xml", "<dialogue>\n<state name='Welcome'/>\n"
                        "<hander name='h'/>\n<var name='x' expr='1+'/>\n"
                        "</dialogue>");
  const auto path = folder.path().string();
  const auto compiled = compile_application(path, test::platform());
  EXPECT_FALSE(compiled.program);
  const auto lines = test::lines_of(compiled.findings, path);
  ASSERT_EQ(lines.size(), 4u);
  EXPECT_EQ(lines[0], "settings.xml:1:18: error: there is no state or topic "
                      "'Welcom' to start with, did you mean 'Welcome'?");
  EXPECT_EQ(lines[1], "settings.xml:4:1: error: there is no file 'b.xml'");
  EXPECT_EQ(lines[2], "a.xml:3:1: error: unknown element <hander> in "
                      "<dialogue>, did you mean 'handler'?");
  EXPECT_THAT(lines[3], testing::StartsWith("a.xml:4:"));
}

} // namespace parlour::script
