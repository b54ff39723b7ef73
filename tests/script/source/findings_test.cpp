#include <gtest/gtest.h>

#include "script/source/findings.hpp"

namespace parlour::script {

TEST(Findings, read_as_file_line_column_severity_message) {
  Findings findings;
  const auto file = findings.add_file("a.xml");
  findings.error({file, 3, 7}, "wrong");
  findings.warning({file, 0, 0}, "odd");
  EXPECT_EQ(to_string(findings.all()[0]), "a.xml:3:7: error: wrong");
  EXPECT_EQ(to_string(findings.all()[1]), "a.xml: warning: odd");
  EXPECT_TRUE(findings.has_errors());
}

TEST(Findings, have_no_errors_where_all_are_warnings) {
  Findings findings;
  findings.warning({findings.add_file("a.xml"), 1, 1}, "odd");
  EXPECT_FALSE(findings.has_errors());
}

TEST(Findings, are_sorted_by_file_as_read_then_place_and_told_once) {
  Findings findings;
  const auto first = findings.add_file("z.xml");
  const auto second = findings.add_file("a.xml");
  findings.error({second, 1, 1}, "c");
  findings.error({first, 10, 1}, "b");
  findings.error({first, 2, 5}, "a");
  findings.error({first, 10, 1}, "b");
  findings.sort();
  ASSERT_EQ(findings.all().size(), 3u);
  EXPECT_EQ(findings.all()[0].message, "a");
  EXPECT_EQ(findings.all()[1].message, "b");
  EXPECT_EQ(findings.all()[2].message, "c");
}

TEST(Findings, know_places_inside_of_values) {
  Findings findings;
  const auto file = findings.add_file("a.xml", "<a>\n<b x='1 &lt; c'/>\n</a>");
  findings.add({Severity::error, {{file, 2, 7}, 4, 1}, "wrong", "name", "d"});
  const auto& finding = findings.all()[0];
  EXPECT_EQ(finding.place, (SourceLocation{"a.xml", 2, 14}));
  EXPECT_EQ(finding.end, (SourceLocation{"a.xml", 2, 15}));
  EXPECT_EQ(finding.range, (TextRange{17, 18}));
  ASSERT_EQ(finding.fix.size(), 1u);
  EXPECT_EQ(finding.fix[0], (Edit{{17, 18}, "d"}));
}

TEST(Findings, write_corrections_as_they_shall_stand_in_the_file) {
  Findings findings;
  const auto file = findings.add_file("a.xml", "<b x='a' y=\"a\"/>");
  const auto written = [&](std::uint32_t column, const char* text) {
    findings.add({Severity::error, {{file, 1, column}}, "", "", text});
    return findings.all().back().fix.at(0).text;
  };
  EXPECT_EQ(written(7, "'Hello'"), "\"Hello\"");
  EXPECT_EQ(written(13, "'Hello'"), "'Hello'");
  EXPECT_EQ(written(7, "'say \"x\"'"), "&apos;say \"x\"&apos;");
  EXPECT_EQ(written(7, "a <= b"), "a &lt;= b");
}

TEST(Findings, end_somewhere) {
  Findings findings;
  const auto file = findings.add_file("a.xml");
  for (std::uint32_t i = 1; i < 5000; ++i)
    findings.warning({file, i, 1}, "odd");
  EXPECT_FALSE(findings.has_errors());
  findings.error({file, 1, 1}, "wrong");
  EXPECT_TRUE(findings.has_errors());
  EXPECT_LT(findings.all().size(), 1010u);
}

TEST(DidYouMean, finds_slips_of_the_hand) {
  const std::vector<std::string> known{"handler", "messages", "state", "var"};
  EXPECT_EQ(nearest("hander", known), "handler");
  EXPECT_EQ(nearest("mesages", known), "messages");
  EXPECT_EQ(nearest("stale", known), "state");
  EXPECT_EQ(nearest("avr", known), "var");
  EXPECT_EQ(nearest("Handler", known), "handler");
}

TEST(DidYouMean, is_silent_where_nothing_is_near) {
  const std::vector<std::string> known{"handler", "state", ""};
  EXPECT_EQ(nearest("topic", known), "");
  EXPECT_EQ(nearest("", known), "");
  EXPECT_EQ(nearest("b", {"a"}), "");
  EXPECT_EQ(nearest("A", {"a"}), "a");
  EXPECT_EQ(nearest(std::string(1000, 'x'), known), "");
  EXPECT_EQ(did_you_mean("xyz", known), "");
  EXPECT_EQ(did_you_mean("stat", known), ", did you mean 'state'?");
}

} // namespace parlour::script
