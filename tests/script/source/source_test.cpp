#include <gtest/gtest.h>

#include "script/source/source.hpp"
#include "tests/script/snippets.hpp"

namespace parlour::script {

TEST(Source, names_of_elements_differ_in_their_first_letter_s_case) {
  EXPECT_TRUE(same_name("Entrance", "entrance"));
  EXPECT_TRUE(same_name("plugin", "Plugin"));
  EXPECT_FALSE(same_name("noInput", "noinput"));
  EXPECT_FALSE(same_name("", "a"));
}

TEST(Source, elements_give_their_attributes_and_children) {
  const auto root = test::tree_of("<a x='1'><B/><b y='2'/></a>");
  EXPECT_EQ(root.value("x"), "1");
  EXPECT_EQ(root.value("y"), "");
  EXPECT_FALSE(root.attribute("y"));
  EXPECT_EQ(root.child("b"), &root.children[0]);
  EXPECT_FALSE(root.child("c"));
}

TEST(Source, white_space_collapses) {
  EXPECT_EQ(collapsed("  Sky \n\t garden "), "Sky garden");
  EXPECT_EQ(collapsed(" \n "), "");
}

} // namespace parlour::script
