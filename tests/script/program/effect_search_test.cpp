#include <gtest/gtest.h>

#include "script/program/effect_search.hpp"
#include "tests/script/snippets.hpp"

namespace parlour::script {

namespace {

bool is_print(EffectKind kind) {
  return kind == EffectKind::print;
}

std::optional<EffectFound> found_in_main(const std::string& functions) {
  const auto compiled = test::compile_declarations(functions);
  const auto& program = *compiled.program;
  return find_effect(program, program.functions.at("main"), is_print);
}

} // namespace

TEST(EffectSearch, finds_the_code_s_own) {
  const auto found = found_in_main(
      "<function name='main'><log param='a'/>\n<print param='b'/></function>");
  ASSERT_TRUE(found);
  EXPECT_FALSE(found->is_called);
  EXPECT_EQ(found->position.line, 2u);
}

TEST(EffectSearch, follows_calls_and_says_where_they_begin) {
  const auto found = found_in_main(
      "<function name='a'><call function='a'/><return expr='b()'/></function>\n"
      "<function name='b'><print param='b'/></function>\n"
      "<function name='main'>\n<var name='x' expr='a()'/></function>");
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->is_called);
  EXPECT_EQ(found->position.line, 2u);
  EXPECT_EQ(found->call.line, 4u);
}

TEST(EffectSearch, finds_nothing_where_nothing_is_wanted) {
  EXPECT_FALSE(found_in_main("<function name='main'><log param='a'/>"
                             "</function><function name='b'><print param='b'/>"
                             "</function>"));
  EXPECT_FALSE(found_in_main("<function name='main'>"
                             "<timer name='t' after='1s'><print param='b'/>"
                             "</timer></function>"));
}

} // namespace parlour::script
