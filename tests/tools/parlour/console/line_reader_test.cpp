#include <vector>

#include <gtest/gtest.h>

#include "tools/parlour/console/line_reader.hpp"

namespace parlour::tools {
namespace {

std::vector<Line> lines_of(std::string_view bytes) {
  LineReader reader;
  std::vector<Line> lines;
  while (auto line = reader.take(bytes))
    lines.push_back(*line);
  if (auto line = reader.finish())
    lines.push_back(*line);
  return lines;
}

std::string only(std::string_view bytes) {
  const auto lines = lines_of(bytes);
  EXPECT_EQ(lines.size(), 1u);
  return lines.empty() ? "" : lines[0].text;
}

const std::string replacement = "\xEF\xBF\xBD";

TEST(LineReader, ends_lines_with_lf_and_cr_lf) {
  const auto lines = lines_of("a\r\nb\n\nc");
  ASSERT_EQ(lines.size(), 4u);
  EXPECT_EQ(lines[0].text, "a");
  EXPECT_EQ(lines[1].text, "b");
  EXPECT_EQ(lines[2].text, "");
  EXPECT_EQ(lines[3].text, "c");
}

TEST(LineReader, gives_nothing_for_nothing) {
  EXPECT_TRUE(lines_of("").empty());
}

TEST(LineReader, puts_a_character_together_from_single_bytes) {
  LineReader reader;
  for (const char byte : std::string("\xE4\xBD\xA0")) {
    std::string_view bytes(&byte, 1);
    EXPECT_FALSE(reader.take(bytes));
  }
  EXPECT_EQ(reader.finish()->text, "\xE4\xBD\xA0");
}

TEST(LineReader, keeps_text_beyond_the_basic_plane) {
  EXPECT_EQ(only("\xF0\x9F\x98\x80 ok"), "\xF0\x9F\x98\x80 ok");
  EXPECT_FALSE(lines_of("\xF0\x9F\x98\x80")[0].repaired);
}

TEST(LineReader, replaces_what_is_no_text) {
  EXPECT_EQ(only("a\xFFz"), "a" + replacement + "z");
  EXPECT_EQ(only("\xC0\xAF"), replacement + replacement);
  EXPECT_EQ(only("\xE4\xBDx"), replacement + "x");
  EXPECT_EQ(only("\xED\xA0\x80"), replacement + replacement + replacement);
  EXPECT_EQ(only("\xE4\xBD"), replacement);
  EXPECT_EQ(only(std::string_view("a\0b", 3)), "a" + replacement + "b");
  EXPECT_TRUE(lines_of("a\xFFz")[0].repaired);
}

TEST(LineReader, keeps_a_line_as_long_as_may_be) {
  const auto line = lines_of(std::string(longest_line, 'x'))[0];
  EXPECT_EQ(line.text.size(), longest_line);
  EXPECT_FALSE(line.cut);
}

TEST(LineReader, cuts_a_longer_line_and_goes_on_after_it) {
  const auto lines = lines_of(std::string(longest_line + 5, 'x') + "\nnext\n");
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0].text.size(), longest_line);
  EXPECT_TRUE(lines[0].cut);
  EXPECT_EQ(lines[1].text, "next");
  EXPECT_FALSE(lines[1].cut);
}

TEST(LineReader, cuts_between_characters) {
  std::string text;
  for (std::size_t i = 0; i <= longest_line; ++i)
    text += "\xC3\xA9";
  EXPECT_EQ(lines_of(text)[0].text.size(), 2 * longest_line);
}

TEST(IsBlank, knows_blanks) {
  EXPECT_TRUE(is_blank(""));
  EXPECT_TRUE(is_blank(" \t "));
  EXPECT_FALSE(is_blank(" a "));
}

} // namespace
} // namespace parlour::tools
