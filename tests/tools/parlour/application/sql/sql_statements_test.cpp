#include <gtest/gtest.h>

#include "tests/script/snippets.hpp"
#include "tools/parlour/application/sql/sql_statements.hpp"

namespace parlour::tools {

namespace {

script::Compiled compile(const std::string& text,
                         test::TemporaryFolder& folder) {
  folder.write("a.xml", text);
  return script::compile_file(folder.path() / "a.xml", test::platform());
}

} // namespace

TEST(SqlStatements, have_placeholders_and_know_their_places) {
  test::TemporaryFolder folder;
  const auto compiled =
      compile("<dialogue><function name='f'><param name='x'/><querydb "
              "param='select a from t where b={x} and c=1' return='r'/><print "
              "param='r'/></function></dialogue>",
              folder);
  ASSERT_TRUE(compiled.program);
  const auto all = sql_statements(compiled);
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].sql, "select a from t where b=? and c=1");
  EXPECT_EQ(all[0].spot(7, 1).skip, 7u);
  const auto c = all[0].sql.find("c=1");
  EXPECT_EQ(all[0].spot(c, 1).skip, c + 2);
}

TEST(SqlStatements, of_other_databases_and_computed_ones_are_left_out) {
  test::TemporaryFolder folder;
  const auto compiled = compile(
      "<dialogue><function name='f'><param name='x'/><querydb db='other' "
      "param='select 1'/><querydb param='x'/></function></dialogue>",
      folder);
  ASSERT_TRUE(compiled.program);
  EXPECT_TRUE(sql_statements(compiled).empty());
}

TEST(SqlStatements, of_topics_are_known_whatever_scripts_connect) {
  test::TemporaryFolder folder;
  const auto compiled = compile(
      "<dialogue><topic name='Staff'><slot name='Name'/><query source='db' "
      "param='select name from staff'/></topic><function name='f'><connectdb "
      "param='x'/><querydb param='select 1'/></function></dialogue>",
      folder);
  ASSERT_TRUE(compiled.program);
  const auto all = sql_statements(compiled);
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].sql, "select name from staff");
}

} // namespace parlour::tools
