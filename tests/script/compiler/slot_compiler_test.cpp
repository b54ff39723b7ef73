#include <gmock/gmock.h>

#include "script/compiler/slot_compiler.hpp"
#include "tests/script/snippets.hpp"

namespace parlour::script {

TEST(SlotCompiler, fills_every_field) {
  const auto outcome = test::compile_declarations(
      "<grammar name='g'>#JSGF V1.0; public &lt;g> = yes;</grammar>"
      "<topic name='t'><slot name='s' type='Functional' expr='1' question='Q?' "
      "confirm='explicit' match='prefix' private='true' grammar='g'>"
      "<cardinality type='range' from='1' to='9'/>"
      "<help><value>H?</value><value expr='1+1'/></help>"
      "<explain><value>E</value></explain>"
      "<filled><print param='a'/></filled><invalid><print param='a'/></invalid>"
      "<ambiguous><print param='a'/></ambiguous>"
      "<noinput count='2'><print param='a'/></noinput>"
      "<nomatch><print param='a'/></nomatch></slot></topic>");
  ASSERT_TRUE(outcome.program) << outcome.lines.at(0);
  const auto& slot = outcome.program->topics.at(0).slots.at(0);
  EXPECT_TRUE(slot.functional);
  EXPECT_TRUE(slot.is_private);
  EXPECT_EQ(slot.confirm, ConfirmPolicy::explicitly);
  EXPECT_EQ(slot.match, Match::prefix);
  EXPECT_EQ(slot.grammar, "g");
  EXPECT_EQ(slot.help.size(), 2u);
  EXPECT_EQ(slot.explain.size(), 1u);
  ASSERT_EQ(slot.no_input.size(), 1u);
  EXPECT_EQ(slot.no_input[0].count, 2u);
  EXPECT_EQ(slot.no_match.at(0).count, 1u);
  for (const auto code :
       {slot.initial, slot.question, slot.filled, slot.invalid, slot.ambiguous,
        slot.cardinality.minimum, slot.cardinality.maximum})
    EXPECT_NE(code, no_code);
}

TEST(SlotCompiler, has_the_defaults_of_the_language) {
  const auto outcome =
      test::compile_declarations("<topic name='t'><slot name='s'/></topic>");
  ASSERT_TRUE(outcome.program);
  const auto& slot = outcome.program->topics.at(0).slots.at(0);
  EXPECT_FALSE(slot.functional);
  EXPECT_FALSE(slot.is_private);
  EXPECT_EQ(slot.confirm, ConfirmPolicy::automatic);
  EXPECT_EQ(slot.match, Match::equal);
  EXPECT_EQ(slot.question, no_code);
  EXPECT_EQ(slot.cardinality.type, "");
}

TEST(SlotCompiler, takes_what_forms_need) {
  const auto outcome = test::compile_declarations(
      "<topic name='a' part='true'><slot name='x'/></topic>"
      "<topic name='t'><slot name='s' if='true' offer='1' label='the s' "
      "commit='true' many='true' more='More?'/>"
      "<slot name='p' topic='a' with='{x: 1}'/></topic>");
  ASSERT_TRUE(outcome.program) << outcome.lines.at(0);
  const auto& slot = outcome.program->topics.at(1).slots.at(0);
  EXPECT_TRUE(slot.commits);
  EXPECT_TRUE(slot.many);
  for (const auto code : {slot.condition, slot.offer, slot.label, slot.more})
    EXPECT_NE(code, no_code);
  EXPECT_EQ(slot.part, no_id);
  const auto& part = outcome.program->topics.at(1).slots.at(1);
  EXPECT_EQ(part.part, 0u);
  EXPECT_NE(part.with, no_code);
}

TEST(SlotCompiler, refuses_what_goes_with_something_else) {
  const auto outcome = test::compile_declarations(
      "<topic name='t'><slot name='a' more='More?'/><slot name='b' with='{}'/>"
      "<slot name='c' topic='Tee'/></topic>");
  ASSERT_EQ(outcome.lines.size(), 3u);
  EXPECT_THAT(outcome.lines.at(0), testing::HasSubstr("write many=\"true\""));
  EXPECT_THAT(outcome.lines.at(1), testing::HasSubstr("name it by 'topic'"));
  EXPECT_THAT(outcome.lines.at(2),
              testing::HasSubstr("there is no topic 'Tee'"));
}

TEST(SlotCompiler, takes_a_column_as_cardinality) {
  const auto outcome = test::compile_declarations(
      "<topic name='t'><slot name='s'><cardinality type='query' "
      "source='db:rr_staff.staff_name'/></slot></topic>");
  ASSERT_TRUE(outcome.program);
  EXPECT_EQ(outcome.program->topics.at(0).slots.at(0).cardinality.source,
            "db:rr_staff.staff_name");
}

} // namespace parlour::script
