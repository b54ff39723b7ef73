#include <gtest/gtest.h>

#include "script/compiler/code/statements/message_statements.hpp"
#include "tests/script/compiler/code/compiled_statements.hpp"

namespace parlour::script {

namespace {

TEST(MessageStatements, TakeParametersInOrder) {
  const auto outcome = test::compile_declarations(
      "<function name='f'><request module='TTS' command='Speak' "
      "param='a' return='r'><catch/></request><fire event='E'/></function>");
  ASSERT_TRUE(outcome.program);
  EXPECT_TRUE(test::has_effect(outcome, EffectKind::request));
  EXPECT_TRUE(test::has_effect(outcome, EffectKind::fire_event));
}

} // namespace

} // namespace parlour::script
