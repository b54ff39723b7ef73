#include <gmock/gmock.h>

#include "script/compiler/route_compiler.hpp"
#include "tests/script/snippets.hpp"

namespace parlour::script {

using testing::ElementsAre;

TEST(RouteCompiler, reads_relays_and_filters_in_order) {
  const auto outcome = test::compile_declarations(
      "<const name='low' expr='0.3'/><routes>"
      "<relay source='Record' command='BufferFull' to='ASR, KeywordSpotter' "
      "as='DoRecognition' param=''/>"
      "<filter source='ASR' command='RecognitionResult' if='_LPARAM2 lt low' "
      "to='NLG'><param expr='_LPARAM1'/></filter>"
      "<filter source='*' command='*' drop='true'/></routes>");
  ASSERT_TRUE(outcome.program) << outcome.lines.at(0);
  const auto& routes = outcome.program->routes;
  ASSERT_EQ(routes.size(), 3u);
  EXPECT_FALSE(routes[0].is_filter);
  EXPECT_THAT(routes[0].to, ElementsAre("ASR", "KeywordSpotter"));
  EXPECT_EQ(routes[0].as, "DoRecognition");
  EXPECT_TRUE(routes[0].has_params);
  EXPECT_TRUE(routes[0].params.empty());
  EXPECT_TRUE(routes[1].is_filter);
  EXPECT_NE(routes[1].condition, no_code);
  EXPECT_EQ(routes[1].params.size(), 1u);
  EXPECT_TRUE(routes[2].drop);
  EXPECT_FALSE(routes[2].has_params);
}

TEST(RouteCompiler, reads_what_opens_a_conversation) {
  const auto outcome = test::compile_declarations(
      "<routes><open source='Devices' command='State' if='_LPARAM1 == 1' "
      "seat='lobby'/><open source='*' command='Arrived'/></routes>");
  ASSERT_TRUE(outcome.program) << outcome.lines.at(0);
  EXPECT_TRUE(outcome.program->routes.empty());
  const auto& openings = outcome.program->openings;
  ASSERT_EQ(openings.size(), 2u);
  EXPECT_EQ(openings[0].source, "Devices");
  EXPECT_EQ(openings[0].command, "State");
  EXPECT_NE(openings[0].condition, no_code);
  EXPECT_EQ(openings[0].seat, "lobby");
  EXPECT_EQ(openings[1].condition, no_code);
  EXPECT_EQ(openings[1].seat, "");
}

TEST(RouteCompiler, sees_nothing_of_a_session) {
  const auto outcome = test::compile_declarations(
      "<var name='v'/><routes><relay source='*' command='*' if='v == 1' "
      "to='ASR'/></routes>");
  ASSERT_EQ(outcome.lines.size(), 1u);
  EXPECT_THAT(outcome.lines[0], testing::HasSubstr("'v'"));
}

} // namespace parlour::script
