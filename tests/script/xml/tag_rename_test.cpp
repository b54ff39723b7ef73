#include <gtest/gtest.h>

#include "script/xml/tag_rename.hpp"

namespace parlour::script {

namespace {

std::string renamed(std::string text, std::size_t begin) {
  const auto edits = rename_tags(text, begin, "new");
  for (auto edit = edits.rbegin(); edit != edits.rend(); ++edit)
    text.replace(edit->range.begin, edit->range.end - edit->range.begin,
                 edit->text);
  return text;
}

} // namespace

TEST(TagRename, changes_start_and_end) {
  EXPECT_EQ(renamed("<a><b x='1'/></a>", 3), "<a><new x='1'/></a>");
  EXPECT_EQ(renamed("<a><b><b/></b></a>", 3), "<a><new><b/></new></a>");
}

TEST(TagRename, leaves_alone_what_it_does_not_understand) {
  EXPECT_EQ(renamed("<a><b></a>", 3), "<a><b></a>");
  EXPECT_EQ(renamed("<a x=1/>", 0), "<a x=1/>");
  EXPECT_EQ(renamed("a", 0), "a");
  EXPECT_EQ(renamed("<a/>", 9), "<a/>");
}

} // namespace parlour::script
