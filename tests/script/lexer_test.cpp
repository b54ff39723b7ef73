#include <gtest/gtest.h>

#include "script/lexer.hpp"

namespace parlour::script {

namespace {

TEST(Lexer, TellsNumbersFromFields) {
  const auto lexed = tokenize("1.5 a.b 2");
  ASSERT_EQ(lexed.tokens.size(), 6u);
  EXPECT_EQ(lexed.tokens[0].number, 1.5);
  EXPECT_EQ(lexed.tokens[2].text, ".");
  EXPECT_EQ(lexed.tokens[4].integer, 2);
}

TEST(Lexer, SaysWhatIsWrongAndWhere) {
  EXPECT_EQ(tokenize("a = 1").error_offset, 2u);
  EXPECT_NE(tokenize("a = 1").error.find("=="), std::string::npos);
  EXPECT_FALSE(tokenize("'\\u{d800}'").error.empty());
  EXPECT_FALSE(tokenize("1e999").error.empty());
  EXPECT_FALSE(tokenize("12ab").error.empty());
}

} // namespace

} // namespace parlour::script
