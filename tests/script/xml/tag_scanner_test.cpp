#include <gtest/gtest.h>

#include "script/xml/tag_scanner.hpp"

namespace parlour::script {

TEST(TagScanner, reads_tags_that_are_right) {
  std::vector<XmlMistake> mistakes;
  const std::string text = "<a x='>' y=\"'\"><b/></a ><!-- <c> -->";
  auto tag = scan_tag(text, 0, mistakes);
  EXPECT_EQ(tag.kind, TagKind::start);
  EXPECT_EQ(tag.name, "a");
  tag = scan_tag(text, tag.end, mistakes);
  EXPECT_EQ(tag.kind, TagKind::empty);
  tag = scan_tag(text, tag.end, mistakes);
  EXPECT_EQ(tag.kind, TagKind::end);
  EXPECT_EQ(tag.name, "a");
  tag = scan_tag(text, tag.end, mistakes);
  EXPECT_EQ(tag.kind, TagKind::other);
  EXPECT_EQ(tag.end, text.size());
  EXPECT_TRUE(mistakes.empty());
}

TEST(TagScanner, goes_on_behind_a_mistake) {
  std::vector<XmlMistake> mistakes;
  const std::string text = "<speak param=Hello/><b/>";
  const auto tag = scan_tag(text, 0, mistakes);
  EXPECT_EQ(tag.kind, TagKind::empty);
  EXPECT_EQ(text.substr(tag.end), "<b/>");
  EXPECT_EQ(mistakes.size(), 1u);
}

TEST(TagScanner, knows_elements_that_hold_nothing) {
  EXPECT_TRUE(holds_nothing("speak"));
  EXPECT_TRUE(holds_nothing("Speak"));
  EXPECT_TRUE(holds_nothing("SPEAK"));
  EXPECT_FALSE(holds_nothing("param") && holds_nothing("if"));
  EXPECT_FALSE(holds_nothing("if"));
  EXPECT_FALSE(holds_nothing("no-such-element"));
}

} // namespace parlour::script
