#include <gtest/gtest.h>

#include "script/spoken/format_pattern.hpp"

namespace parlour::script {

namespace {

TEST(FormatPattern, IsReadInPieces) {
  const auto pattern = parse_format("a {} b {:*^+08,.2u} {{c}}");
  EXPECT_EQ(pattern.error, "");
  ASSERT_EQ(pattern.pieces.size(), 3u);
  EXPECT_EQ(pattern.places, 2u);
  EXPECT_EQ(pattern.pieces[0].text, "a ");
  const auto& format = *pattern.pieces[1].format;
  EXPECT_EQ(format.fill, "*");
  EXPECT_EQ(format.align, '^');
  EXPECT_TRUE(format.sign && format.zeros && format.thousands);
  EXPECT_EQ(format.width, 8u);
  EXPECT_EQ(format.decimals, 2);
  EXPECT_EQ(format.letters, 'u');
  EXPECT_EQ(pattern.pieces[2].text, " {c}");
  EXPECT_FALSE(pattern.pieces[2].format);
}

TEST(FormatPattern, TellsWhatIsWrong) {
  for (const auto* wrong : {"{:", "{:z}", "{:5", "{:.}", "{:5 }", "{:.2f}",
                            "{:99999999999999999999}", "{:.21}", "{:,,}"})
    EXPECT_NE(parse_format(wrong).error, "") << wrong;
  for (const auto* right : {"", "{", "}", "{x}", "{:}", "{:0}", "{:<}"})
    EXPECT_EQ(parse_format(right).error, "") << right;
}

} // namespace

} // namespace parlour::script
