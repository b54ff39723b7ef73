#include <string>

#include <gtest/gtest.h>

#include "script/format/layout_tree.hpp"

namespace parlour::script {

TEST(LayoutTree, keeps_what_matters) {
  const std::string text = "<!-- a -->\n<r x = 'a>b' y=\"'\">\n\n  <b/> <!-- c "
                           "-->\n <v>t</v></r>";
  const auto nodes = layout_tree(text);
  ASSERT_EQ(nodes.size(), 2u);
  EXPECT_EQ(nodes[0].kind, LayoutNode::Kind::comment);
  const auto& root = nodes[1];
  EXPECT_EQ(root.name, "r");
  EXPECT_EQ(root.names, (std::vector<std::string_view>{"x", "y"}));
  EXPECT_EQ(root.values, (std::vector<std::string_view>{"'a>b'", "\"'\""}));
  ASSERT_EQ(root.children.size(), 3u);
  EXPECT_EQ(root.children[0].raw, "<b/>");
  EXPECT_TRUE(root.children[1].on_same_line);
  EXPECT_FALSE(root.children[2].on_same_line);
  EXPECT_TRUE(root.children[2].has_text());
  EXPECT_EQ(root.children[2].inside, "t");
}

TEST(LayoutTree, knows_empty_lines_before_all_but_the_first) {
  const auto nodes = layout_tree("<r>\n\n<a/>\n\n\n<b/>\n<c/></r>");
  const auto& children = nodes.at(0).children;
  EXPECT_FALSE(children[0].after_empty_line);
  EXPECT_TRUE(children[1].after_empty_line);
  EXPECT_FALSE(children[2].after_empty_line);
}

} // namespace parlour::script
