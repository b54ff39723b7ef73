#include <gtest/gtest.h>

#include "adapters/files/encoding.hpp"

namespace parlour::adapters {
namespace {

TEST(Encoding, TellsUtf8) {
  EXPECT_TRUE(is_utf8(""));
  EXPECT_TRUE(is_utf8("a\u00e9\u20ac\U0001F600\n"));
  EXPECT_TRUE(is_utf8(std::string_view("a\0b", 3)));
  EXPECT_FALSE(is_utf8("caf\xe9"));
  EXPECT_FALSE(is_utf8("\xc3"));
  EXPECT_FALSE(is_utf8("\xc0\xaf"));     // a '/' of two bytes
  EXPECT_FALSE(is_utf8("\xed\xa0\x80")); // half of a pair
}

} // namespace
} // namespace parlour::adapters
