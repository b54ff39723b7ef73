#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "script/vm/listing.hpp"
#include "tests/script/snippets.hpp"

namespace parlour::script {

using testing::HasSubstr;

TEST(Listing, NamesRegistersConstantsAndWhatIsCalled) {
  const auto outcome = test::compile_declarations(
      "<var name='count' expr='0'/>"
      "<function name='more'><param name='by'/>"
      "<set name='count' expr='count + by + 1'/></function>"
      "<function name='main'><set name='count' expr='more(2)'/>"
      "<if cond='count gt 2'><print param='{upper(count)} a'/></if>"
      "</function>");
  ASSERT_TRUE(outcome.program) << outcome.lines.at(0);
  const auto text = listing(*outcome.program);
  EXPECT_THAT(text, HasSubstr("function more: 1 of 1 parameters needed"));
  EXPECT_THAT(text, HasSubstr("a.xml:1\n"));
  EXPECT_THAT(text, HasSubstr("session variable count = r"));
  EXPECT_THAT(text, HasSubstr("= code 'function more' of 1 registers from r"));
  EXPECT_THAT(text, HasSubstr("built-in upper of 1 registers from r"));
  EXPECT_THAT(text, HasSubstr("\" a\""));
  EXPECT_THAT(text, HasSubstr("end with unknown"));
  // No field's name is left where its value belongs; `for each` is none.
  EXPECT_THAT(text, testing::Not(testing::ContainsRegex("`[a-z]+`")));
}

TEST(Listing, SaysWhereJumpsLead) {
  const auto outcome = test::compile_declarations(
      "<function name='main'><var name='x' expr='1'/>"
      "<while cond='x lt 3'><set name='x' expr='x + 1'/></while></function>");
  ASSERT_TRUE(outcome.program);
  const auto text = listing(*outcome.program);
  EXPECT_THAT(text,
              testing::ContainsRegex("jump_if_[a-z_]+ +if [^\n]*, to [0-9]"));
  EXPECT_THAT(text, testing::ContainsRegex("loop +go back to [0-9]"));
}

} // namespace parlour::script
