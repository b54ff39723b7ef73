#include <gmock/gmock.h>

#include "script/lint/lint_context.hpp"
#include "tests/script/snippets.hpp"

namespace parlour::script::lint {

using testing::UnorderedElementsAre;

TEST(LintContext, knows_what_an_element_mentions) {
  const auto root = test::tree_of(
      "<dialogue><function name='f'>"
      "<print param='Hello {a} {b[c]} {{d}}'/><set name='e.f' expr='g(h)'/>"
      "<set name='i' expr=\"'j' + this.K\"/><print param='l'/>"
      "<querydb param='select {m}' args='n, o' return='p'/>"
      "</function></dialogue>");
  const auto mentions = all_mentions(root, rule_of(root));
  EXPECT_THAT(mentions.names, UnorderedElementsAre("a", "b", "c", "e", "h", "l",
                                                   "m", "n", "o", "this"));
  EXPECT_THAT(mentions.calls, UnorderedElementsAre("g"));
  EXPECT_THAT(mentions.slots, UnorderedElementsAre("K"));
}

} // namespace parlour::script::lint
