#include <gmock/gmock.h>

#include "script/compiler/reaction_compiler.hpp"
#include "tests/script/snippets.hpp"

namespace parlour::script {

TEST(ReactionCompiler, takes_both_forms_and_spells_names_as_the_roles_do) {
  const auto outcome = test::compile_declarations(
      "<handler name='h'><messages><component><record><bufferFull/></record>"
      "<on source='*' event='Failed'/></component>"
      "<on source='ASR' event='Partial'/></messages></handler>");
  ASSERT_TRUE(outcome.program) << outcome.lines.at(0);
  EXPECT_THAT(outcome.lines, testing::IsEmpty());
  const auto& reactions = outcome.program->handlers.at(0).reactions;
  ASSERT_EQ(reactions.size(), 3u);
  EXPECT_EQ(reactions[0].source, "Record");
  EXPECT_EQ(reactions[0].event, "BufferFull");
  EXPECT_EQ(reactions[1].source, "*");
  EXPECT_EQ(reactions[1].event, "Failed");
  EXPECT_EQ(reactions[2].source, "ASR");
  EXPECT_EQ(reactions[2].event, "Partial");
}

TEST(ReactionCompiler, knows_the_settings_components_and_agents) {
  Program program;
  program.settings.components.push_back({"Desk", "AlsaMicrophone", {}, {}});
  program.settings.agents.agents.push_back({.name = "Olivia"});
  const auto sources = known_sources(program);
  for (const auto* name :
       {"Desk", "AlsaMicrophone", "Olivia", "Record", "Session"})
    EXPECT_THAT(sources, testing::Contains(name));
}

} // namespace parlour::script
