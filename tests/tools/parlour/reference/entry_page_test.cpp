#include <gtest/gtest.h>

#include "tools/parlour/reference/entry_page.hpp"

namespace parlour::tools {
namespace {

const Entry& lift() {
  static const Entry entry{
      "lift",
      "<lift>",
      "a lift [of](a) *hotel*",
      {{"stands in", "<hotel>, and in whatever else has more than one floor "
                     "where guests live"},
       {"told in", "5.1"}},
      {{"floor", "needed; a number", "where it <stops>"}},
      "<lift floor=\"2\"/>\n<lift/>"};
  return entry;
}

TEST(EntryPage, IsASectionOfMarkdown) {
  EXPECT_EQ(entry_section(lift()),
            "## `<lift>`\n\na lift \\[of\\]\\(a) \\*hotel\\*\n\n"
            "* stands in: `<hotel>`, and in whatever else has more than one "
            "floor where guests live\n"
            "* told in: [language rule 5.1](../../script/LANGUAGE.md)\n\n"
            "| attribute | takes | what it is |\n| --- | --- | --- |\n"
            "| `floor` | needed; a number | where it `<stops>` |\n\n"
            "```xml\n<lift floor=\"2\"/>\n<lift/>\n```\n");
}

TEST(EntryPage, IsLinkedByItsHeading) {
  EXPECT_EQ(link_to(lift(), "x.md"), "[`<lift>`](x.md#lift)");
  EXPECT_EQ(link_to({"var", "<var> in <call>", ""}, "x.md"),
            "[`<var>` in `<call>`](x.md#var-in-call)");
}

} // namespace
} // namespace parlour::tools
