#include <gtest/gtest.h>

#include "runtime/base/utf8.hpp"

namespace parlour {

TEST(Utf8, is_told_from_what_is_not) {
  EXPECT_FALSE(find_invalid_utf8("Grüße, 日本, 😀"));
  EXPECT_EQ(find_invalid_utf8("a\xff"), 1u);
  EXPECT_EQ(find_invalid_utf8("ab\xc3"), 2u);
  EXPECT_EQ(find_invalid_utf8("\xc0\x80"), 0u);         // overlong
  EXPECT_EQ(find_invalid_utf8("\xed\xa0\x80"), 0u);     // surrogate
  EXPECT_EQ(find_invalid_utf8("\xf4\x90\x80\x80"), 0u); // too large
}

} // namespace parlour
