#include <gtest/gtest.h>

#include "script/source/excerpt.hpp"

namespace parlour::script {

namespace {

std::string shown(const std::string& text, std::uint32_t line,
                  std::uint32_t column, std::size_t length = 0) {
  Findings findings;
  const auto file = findings.add_file("a.xml", text);
  findings.add({Severity::error, {{file, line, column}, 0, length}, "wrong"});
  return excerpt(findings.text(file), findings.all().front());
}

} // namespace

TEST(Excerpt, marks_the_place) {
  EXPECT_EQ(shown("<a>\n  <b x='1'/>\n</a>", 2, 3), "    2 |   <b x='1'/>\n"
                                                    "      |   ^^\n");
  EXPECT_EQ(shown("<a x='12 + c'/>", 1, 12), "    1 | <a x='12 + c'/>\n"
                                             "      |            ^\n");
}

TEST(Excerpt, counts_code_points_and_keeps_tabs) {
  EXPECT_EQ(shown("\t<é x='日'/>", 1, 8, 3), "    1 | \t<é x='日'/>\n"
                                             "      | \t      ^\n");
}

TEST(Excerpt, marks_the_first_line_of_what_is_longer) {
  EXPECT_EQ(shown("<a x='b\nc'/>", 1, 7), "    1 | <a x='b\n"
                                          "      |       ^\n");
}

TEST(Excerpt, shows_the_part_of_a_long_line_that_matters) {
  const std::string text(150, 'x');
  const auto line = shown(text + " y " + text, 1, 152);
  EXPECT_EQ(line.find("…"), 8u);
  EXPECT_NE(line.find("x y x"), std::string::npos);
  EXPECT_LT(line.size(), 250u);
}

TEST(Excerpt, is_empty_where_there_is_no_place) {
  EXPECT_EQ(shown("<a/>", 0, 0), "");
  EXPECT_EQ(shown("", 1, 1), "");
}

TEST(Excerpt, stands_at_the_end_of_the_file_too) {
  EXPECT_EQ(shown("<a>", 1, 4), "    1 | <a>\n"
                                "      |    ^\n");
  EXPECT_EQ(shown("<a>\n", 2, 1), "    2 | \n"
                                  "      | ^\n");
}

} // namespace parlour::script
