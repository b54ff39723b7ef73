#include <gmock/gmock.h>

#include "script/allowances.hpp"

namespace parlour::script {

using testing::ElementsAre;

TEST(Allowances, are_read_from_comments) {
  const auto all = read_allowances("<a>\n<!-- check: allow one, two -->\n"
                                   "<b/> <!--check: allow three-->\n"
                                   "<!-- check: allow four in this file -->");
  ASSERT_EQ(all.size(), 3u);
  EXPECT_EQ(all[0].line, 2u);
  EXPECT_TRUE(all[0].alone);
  EXPECT_THAT(all[0].names, ElementsAre("one", "two"));
  EXPECT_EQ(all[1].line, 3u);
  EXPECT_FALSE(all[1].alone);
  EXPECT_TRUE(all[2].whole_file);
  EXPECT_THAT(all[2].names, ElementsAre("four"));
}

TEST(Allowances, stand_in_comments_only) {
  EXPECT_TRUE(read_allowances("<a x='check: allow one'/>").empty());
  EXPECT_TRUE(read_allowances("<!-- to check: allow one -->").empty());
  EXPECT_TRUE(read_allowances("<!-- check: allow one").empty());
}

TEST(Allowances, take_no_errors_out) {
  Findings findings;
  const auto file =
      findings.add_file("a.xml", "<a/> <!-- check: allow xml -->");
  findings.add({Severity::error, {{file, 1, 1}}, "wrong", "xml"});
  findings.add({Severity::warning, {{file, 1, 1}}, "odd", "xml"});
  take_allowed(findings);
  ASSERT_EQ(findings.all().size(), 1u);
  EXPECT_EQ(findings.all()[0].severity, Severity::error);
}

} // namespace parlour::script
