#include <gmock/gmock.h>

#include "script/compiler/knowledge_compiler.hpp"
#include "tests/script/snippets.hpp"

namespace parlour::script {

using testing::ElementsAre;

TEST(KnowledgeCompiler, reads_queries) {
  const auto outcome = test::compile_declarations(
      "<topic name='t'><slot name='Category'/><slot name='Level'/>"
      "<query source='db:house' param='select name from f' order='name'>"
      "<by slot='Category' column='category' match='contains'/>"
      "<by slot='Level' relax='1'/></query></topic>");
  ASSERT_TRUE(outcome.program) << outcome.lines.at(0);
  const auto& query = outcome.program->topics.at(0).queries.at(0);
  EXPECT_EQ(query.kind, "db");
  EXPECT_EQ(query.name, "house");
  EXPECT_EQ(query.statement, "select name from f");
  EXPECT_EQ(query.order, "name");
  ASSERT_EQ(query.by.size(), 2u);
  EXPECT_EQ(query.by[0].column, "category");
  EXPECT_EQ(query.by[0].match, Match::contains);
  EXPECT_EQ(query.by[0].relax, 0u);
  EXPECT_EQ(query.by[1].slot, 1u);
  EXPECT_EQ(query.by[1].column, "Level");
  EXPECT_EQ(query.by[1].relax, 1u);
}

TEST(KnowledgeCompiler, reads_facts_like_a_table) {
  const auto outcome = test::compile_declarations(
      "<topic name='t'><query source='facts'/></topic>"
      "<facts name='f'><fact a='1'/><fact b='2' a='3'/></facts>");
  ASSERT_TRUE(outcome.program) << outcome.lines.at(0);
  const auto& table = outcome.program->facts.at(0);
  EXPECT_THAT(table.rows.columns, ElementsAre("a", "b"));
  ASSERT_EQ(table.rows.row_count(), 2u);
  EXPECT_TRUE(table.rows.cell(0, "b")->is_unknown());
  EXPECT_EQ(table.rows.cell(1, "a")->text(), "3");
  EXPECT_EQ(outcome.program->topics.at(0).queries.at(0).name, "f");
}

} // namespace parlour::script
