#include <gmock/gmock.h>

#include "script/xml/allowances.hpp"

namespace parlour::script {

using testing::ElementsAre;

TEST(Allowances, are_read_from_comments) {
  const auto all = read_allowances("<a>\n<!-- check: allow one, two -->\n"
                                   "<b/> <!--check: allow three-->\n"
                                   "<!-- check: allow four in this file -->");
  ASSERT_EQ(all.size(), 3u);
  EXPECT_EQ(all[0].first, 2u);
  EXPECT_EQ(all[0].last, 3u);
  EXPECT_THAT(all[0].names, ElementsAre("one", "two"));
  EXPECT_EQ(all[1].first, 3u);
  EXPECT_EQ(all[1].last, 3u);
  EXPECT_TRUE(all[2].whole_file);
  EXPECT_THAT(all[2].names, ElementsAre("four"));
}

TEST(Allowances, are_for_all_lines_of_a_tag) {
  const auto above = read_allowances("<a>\n<!-- check: allow one -->\n"
                                     "<b\n x='1'\n y='2'/>\n<c/></a>");
  ASSERT_EQ(above.size(), 1u);
  EXPECT_EQ(above[0].first, 2u);
  EXPECT_EQ(above[0].last, 5u);
  const auto behind =
      read_allowances("<a>\n<b\n x='1'/> <!-- check: allow one -->\n<c/></a>");
  ASSERT_EQ(behind.size(), 1u);
  EXPECT_EQ(behind[0].first, 2u);
  EXPECT_EQ(behind[0].last, 3u);
}

TEST(Allowances, may_stand_one_below_the_other) {
  const auto all = read_allowances("<!-- check: allow one -->\n"
                                   "<!-- check: allow two -->\n<a/>\n<b/>");
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].last, 3u);
  EXPECT_EQ(all[1].last, 3u);
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
