#include <algorithm>

#include <gtest/gtest.h>

#include "script/compiler/code/statements/detached_statements.hpp"
#include "tests/script/compiler/code/compiled_statements.hpp"

namespace parlour::script {

namespace {

TEST(DetachedStatements, TakeTheLocalsThatTheyMention) {
  EXPECT_EQ(
      test::printed(
          R"x(<var name="a" expr="1"/><var name="ab" expr="2"/><timer name="t" after="1s"><print param="{ab}"/></timer><set name="ab" expr="3"/>)x"),
      "2\n");
}

TEST(DetachedStatements, TakeNoLocalWhoseNameIsPartOfAnother) {
  const auto outcome = test::compile_declarations(
      "<function name='f'><var name='count' expr='1'/><var name='counter' "
      "expr='2'/><timer name='t' after='1s'><print param='count {counter}'/>"
      "</timer></function>");
  ASSERT_TRUE(outcome.program);
  const auto& all = outcome.program->code;
  const auto timer = std::find_if(all.begin(), all.end(), [](const Code& code) {
    return code.name.starts_with("timer 't' in");
  });
  ASSERT_NE(timer, all.end());
  EXPECT_EQ(timer->parameter_names, std::vector<std::string>{"counter"});
}

// One whose name is computed has none.
TEST(DetachedStatements, AreNamedAfterTheirTimers) {
  const auto outcome = test::compile_declarations(
      "<function name='f'><timer name='t' after='1s'><print param='a'/></timer>"
      "<timer name='t{1 + 1}' after='1s'><print param='b'/></timer>"
      "</function>");
  ASSERT_TRUE(outcome.program);
  std::vector<std::string> names;
  for (const auto& code : outcome.program->code)
    if (code.name.starts_with("timer"))
      names.push_back(code.name);
  EXPECT_EQ(names, (std::vector<std::string>{"timer 't' in function f",
                                             "timer in function f"}));
}

} // namespace

} // namespace parlour::script
