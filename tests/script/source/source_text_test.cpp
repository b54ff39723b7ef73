#include <gtest/gtest.h>

#include "script/source/source_text.hpp"

namespace parlour::script {

namespace {

constexpr const char* mark = "\xef\xbb\xbf";

std::string behind(const std::string& text, const std::string& value,
                   std::size_t skip, bool collapsed = false) {
  const SourceText source(text);
  return text.substr(source.inside(text.find(value), skip, collapsed));
}

std::string underlined(const std::string& text, const std::string& from) {
  const SourceText source(text);
  const auto begin = text.find(from);
  return text.substr(begin, source.end_of(begin) - begin);
}

} // namespace

TEST(SourceText, places_are_found_and_told) {
  const SourceText source("<a>\n  <b/></a>");
  EXPECT_EQ(source.offset_of({0, 2, 3}), 6u);
  EXPECT_EQ(source.at(6), (Position{0, 2, 3}));
}

TEST(SourceText, a_byte_order_mark_has_no_column) {
  const SourceText source(mark + std::string("<a/>"));
  EXPECT_EQ(source.offset_of({0, 1, 1}), 3u);
  EXPECT_EQ(source.at(3), (Position{0, 1, 1}));
  EXPECT_EQ(source.at(0), (Position{0, 1, 1}));
}

TEST(SourceText, an_entity_is_one_character_of_the_value) {
  EXPECT_EQ(behind("x='a &lt; b'", "a", 4), "b'");
  EXPECT_EQ(behind("x='&#233;&amp; b'", "&#", 4), "b'");
  EXPECT_EQ(behind("x='a & b'", "a", 4), "b'"); // not well-formed, as it is
  EXPECT_EQ(behind("x='a\r\nb'", "a", 2), "b'");
}

TEST(SourceText, blanks_and_comments_count_as_in_collapsed_text) {
  EXPECT_EQ(behind("<v>\n  a \n  b</v>", "\n", 2, true), "b</v>");
  EXPECT_EQ(behind("<v>a<!-- c --> b</v>", "a", 2, true), "b</v>");
  EXPECT_EQ(behind("<v><![CDATA[a b]]></v>", "<![", 2, true), "b]]></v>");
}

TEST(SourceText, a_reader_points_at_tags_values_words) {
  EXPECT_EQ(underlined("<a><speak x=''/>", "<speak"), "<speak");
  EXPECT_EQ(underlined("<a></speak >", "</sp"), "</speak");
  EXPECT_EQ(underlined("<a><b></b></a>", "<b>"), "<b>");
  EXPECT_EQ(underlined("<a x = 'b c'/>", "b c"), "b c");
  EXPECT_EQ(underlined("<a to-session='b'/>", "to-"), "to-session");
  EXPECT_EQ(underlined("a + b", "+"), "+");
}

} // namespace parlour::script
