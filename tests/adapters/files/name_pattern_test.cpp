#include <string>

#include <gtest/gtest.h>

#include "adapters/files/name_pattern.hpp"

namespace parlour::adapters {
namespace {

TEST(NamePattern, Fits) {
  EXPECT_TRUE(fits_pattern("a.txt", "a.txt"));
  EXPECT_TRUE(fits_pattern("*", "a.txt"));
  EXPECT_TRUE(fits_pattern("*.txt", "a.txt"));
  EXPECT_TRUE(fits_pattern("a*b*c", "aXbYbZc"));
  EXPECT_TRUE(fits_pattern("**", "a"));
  EXPECT_TRUE(fits_pattern("?", "é"));
  EXPECT_TRUE(fits_pattern("*?", "é"));
}

TEST(NamePattern, DoesNotFit) {
  EXPECT_FALSE(fits_pattern("a.txt", "b.txt"));
  EXPECT_FALSE(fits_pattern("*.txt", "a.txt.old"));
  EXPECT_FALSE(fits_pattern("A.txt", "a.txt"));
  EXPECT_FALSE(fits_pattern("?", ""));
  EXPECT_FALSE(fits_pattern("??", "é"));
  EXPECT_FALSE(fits_pattern("*", ".hidden"));
  EXPECT_FALSE(fits_pattern("", "a"));
}

TEST(NamePattern, TakesNoTimeToSpeakOf) {
  std::string pattern;
  for (int i = 0; i < 60; ++i)
    pattern += "*a";
  EXPECT_FALSE(fits_pattern(pattern + "b", std::string(250, 'a')));
}

} // namespace
} // namespace parlour::adapters
