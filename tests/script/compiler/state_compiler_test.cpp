#include <gmock/gmock.h>

#include "script/compiler/state_compiler.hpp"
#include "tests/script/snippets.hpp"

namespace parlour::script {

TEST(StateCompiler, fills_every_field) {
  const auto outcome = test::compile_declarations(
      "<state name='s' capture='all'><Entrance><print param='a'/></Entrance>"
      "<Exit><print param='a'/></Exit><Messages><component><ASR>"
      "<RecognitionResult><print param='a'/></RecognitionResult></ASR>"
      "</component></Messages><Online><agent name='Olivia'><print param='a'/>"
      "</agent><print param='b'/></Online><Offline><print param='b'/></Offline>"
      "<functions><function name='f'/></functions></state>");
  ASSERT_TRUE(outcome.program) << outcome.lines.at(0);
  const auto& state = outcome.program->states.at(0);
  EXPECT_EQ(state.capture, Capture::all);
  EXPECT_NE(state.entrance, no_code);
  EXPECT_NE(state.exit, no_code);
  EXPECT_EQ(state.messages.size(), 1u);
  ASSERT_EQ(state.online.size(), 2u);
  EXPECT_EQ(state.online[0].source, "Olivia");
  EXPECT_EQ(state.online[1].source, "*");
  EXPECT_EQ(state.offline.size(), 1u);
}

TEST(StateCompiler, refuses_a_transit_in_exit) {
  const auto outcome = test::compile_declarations(
      "<state name='s'><Exit><transit state='s'/></Exit></state>");
  ASSERT_EQ(outcome.lines.size(), 1u);
  EXPECT_THAT(outcome.lines[0], testing::HasSubstr("error"));
}

} // namespace parlour::script
