#include <string>

#include <gtest/gtest.h>

#include "adapters/database/row_texts.hpp"

namespace parlour::adapters {
namespace {

TEST(RowTexts, AreValuesOfTheirOwn) {
  RowTexts texts(3);
  const auto first = texts.add("");
  const auto second = texts.add(std::string(100, 'b'));
  const auto third = texts.add(std::string_view("c\0d", 3));
  EXPECT_EQ(first, Value(""));
  EXPECT_EQ(second, Value(std::string(100, 'b')));
  EXPECT_EQ(third, Value(std::string("c\0d", 3)));
}

TEST(RowTexts, OutliveTheRow) {
  Value kept;
  {
    RowTexts texts(2);
    kept = texts.add("kept, though it is longer than a short text");
    (void)texts.add("let go");
  }
  EXPECT_EQ(kept, Value("kept, though it is longer than a short text"));
}

TEST(RowTexts, AreUtf8) {
  RowTexts texts(2);
  EXPECT_EQ(texts.add("a\xff"
                      "b"),
            Value("a\xEF\xBF\xBD"
                  "b"));
  EXPECT_EQ(texts.add("Müller 陈"), Value("Müller 陈"));
}

} // namespace
} // namespace parlour::adapters
