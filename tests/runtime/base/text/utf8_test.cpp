#include <gtest/gtest.h>

#include "runtime/base/text/utf8.hpp"

namespace parlour {

TEST(Utf8, is_told_from_what_is_not) {
  EXPECT_FALSE(find_invalid_utf8("Grüße, 日本, 😀"));
  EXPECT_EQ(find_invalid_utf8("a\xff"), 1u);
  EXPECT_EQ(find_invalid_utf8("seven\xff."), 5u);
  EXPECT_EQ(find_invalid_utf8("\xff first of nine"), 0u);
  EXPECT_EQ(find_invalid_utf8("1234567\xff"
                              "9abcdef"),
            7u);
  EXPECT_EQ(find_invalid_utf8("12345678\xff"
                              "a"),
            8u);
  EXPECT_EQ(find_invalid_utf8("12345678 ten\xff"), 12u);
  EXPECT_FALSE(find_invalid_utf8(""));
  EXPECT_FALSE(find_invalid_utf8("12345678"));
  EXPECT_EQ(find_invalid_utf8("ab\xc3"), 2u);
  EXPECT_EQ(find_invalid_utf8("\xc0\x80"), 0u);         // overlong
  EXPECT_EQ(find_invalid_utf8("\xed\xa0\x80"), 0u);     // surrogate
  EXPECT_EQ(find_invalid_utf8("\xf4\x90\x80\x80"), 0u); // too large
}

TEST(Utf8, further_bytes_continue_a_code_point) {
  EXPECT_FALSE(continues_code_point('a'));
  EXPECT_FALSE(continues_code_point('\xc3'));
  EXPECT_TRUE(continues_code_point('\xbc'));
}

TEST(Utf8, ascii_is_passed_eight_bytes_at_a_time) {
  EXPECT_EQ(ascii_up_to("0123456789abcdef", 0), 16u);
  EXPECT_EQ(ascii_up_to("0123456789abcd\xc3\xbc", 0), 8u);
  EXPECT_EQ(ascii_up_to("0123456789abcd\xc3\xbc", 3), 11u);
  EXPECT_EQ(ascii_up_to("0123", 0), 0u);
}

TEST(Utf8, code_points_of_every_length_are_appended) {
  std::string text;
  for (const std::uint32_t code : {0x41u, 0xfcu, 0x20acu, 0x1f916u})
    append_code_point(text, code);
  EXPECT_EQ(text, "A\xc3\xbc\xe2\x82\xac\xf0\x9f\xa4\x96");
  EXPECT_FALSE(find_invalid_utf8(text));
}

} // namespace parlour
