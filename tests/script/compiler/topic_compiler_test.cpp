#include <gmock/gmock.h>

#include "script/compiler/topic_compiler.hpp"
#include "tests/script/snippets.hpp"

namespace parlour::script {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(TopicCompiler, fills_every_field) {
  const auto outcome = test::compile_declarations(
      "<topic name='Visit'/>"
      "<topic name='t' kind='enquiry' initiative='user' resume='ask' "
      "needs='Visit'><slot name='A'/><slot name='B'/>"
      "<constraint cond='this.A gt this.B' message='no'/>"
      "<rule if='this.A'><clear slot='B'/></rule>"
      "<query source='db' param='select 1'/>"
      "<started><print param='a'/></started><suspended><print param='a'/>"
      "</suspended><resumed><print param='a'/></resumed><filled>"
      "<complete/></filled><completed><print param='a'/></completed><cancelled>"
      "<print param='a'/></cancelled></topic>");
  ASSERT_TRUE(outcome.program) << outcome.lines.at(0);
  EXPECT_THAT(outcome.lines, IsEmpty());
  const auto& topic = outcome.program->topics.at(1);
  EXPECT_EQ(topic.kind, TopicKind::enquiry);
  EXPECT_EQ(topic.initiative, Initiative::user);
  EXPECT_EQ(topic.resume, ResumePolicy::ask);
  EXPECT_THAT(topic.needs, ElementsAre("Visit"));
  EXPECT_EQ(topic.constraints.size(), 1u);
  EXPECT_EQ(topic.rules.size(), 1u);
  for (const auto code : {topic.started, topic.suspended, topic.resumed,
                          topic.filled, topic.completed, topic.cancelled})
    EXPECT_NE(code, no_code);
}

TEST(TopicCompiler, has_the_defaults_of_the_language) {
  const auto outcome = test::compile_declarations("<topic name='t'/>");
  ASSERT_TRUE(outcome.program);
  const auto& topic = outcome.program->topics.at(0);
  EXPECT_EQ(topic.kind, TopicKind::task);
  EXPECT_EQ(topic.initiative, Initiative::mixed);
  EXPECT_EQ(topic.resume, ResumePolicy::always);
  EXPECT_EQ(topic.filled, no_code);
}

TEST(TopicCompiler, takes_what_confirms_the_whole) {
  const auto outcome = test::compile_declarations(
      "<topic name='a' confirm='summary' label='the a' part='true'/>"
      "<topic name='b' commit='true'><refused><print param='a'/></refused>"
      "</topic><topic name='c' confirm='never'/>");
  ASSERT_TRUE(outcome.program) << outcome.lines.at(0);
  const auto& topics = outcome.program->topics;
  EXPECT_EQ(topics.at(0).summary, Summary::always);
  EXPECT_TRUE(topics.at(0).is_part);
  EXPECT_NE(topics.at(0).label, no_code);
  EXPECT_NE(topics.at(0).filled, no_code); // the question itself
  EXPECT_EQ(topics.at(1).summary, Summary::unless_certain);
  EXPECT_EQ(topics.at(2).summary, Summary::never);
  EXPECT_EQ(topics.at(2).filled, no_code);
}

TEST(TopicCompiler, refuses_a_summary_of_what_is_not_done) {
  const auto outcome = test::compile_declarations(
      "<topic name='a' kind='enquiry' confirm='summary'><filled/></topic>"
      "<topic name='b'><refused/></topic>");
  ASSERT_EQ(outcome.lines.size(), 2u);
  EXPECT_THAT(outcome.lines.at(0),
              testing::HasSubstr("does nothing that could be confirmed"));
  EXPECT_THAT(outcome.lines.at(1),
              testing::HasSubstr("<refused> runs after a no to the summary"));
}

TEST(TopicCompiler, refuses_topics_that_are_part_of_themselves) {
  const auto outcome = test::compile_declarations(
      "<topic name='a'><slot name='B' topic='b'/></topic>"
      "<topic name='b' needs='a'/>");
  ASSERT_EQ(outcome.lines.size(), 1u);
  EXPECT_THAT(outcome.lines.at(0), testing::HasSubstr("needs itself"));
}

TEST(TopicCompiler, keeps_functions_to_themselves) {
  const auto outcome = test::compile_declarations(
      "<topic name='t'><functions><function name='f'/></functions>"
      "<started><call function='f'/></started></topic>"
      "<function name='g'><call function='f'/></function>");
  EXPECT_FALSE(outcome.program);
  EXPECT_EQ(outcome.lines.size(), 1u);
}

TEST(TopicCompiler, refuses_topics_that_need_each_other) {
  const auto outcome = test::compile_declarations(
      "<topic name='a' needs='b'/><topic name='b' needs='a'/>");
  EXPECT_THAT(outcome.lines,
              ElementsAre("a.xml:1:11: error: topic 'a' needs itself, by its "
                          "'needs'"));
}

} // namespace parlour::script
