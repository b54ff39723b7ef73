#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "script/expression/lexer.hpp"

namespace parlour::script {

namespace {

std::vector<Token> tokens_of(Lexer& lexer) {
  std::vector<Token> all;
  do
    all.push_back(lexer.next());
  while (all.back().kind != TokenKind::end);
  return all;
}

// The lexer where it gave up.
Lexer failed(std::string_view text) {
  Lexer lexer(text);
  tokens_of(lexer);
  return lexer;
}

TEST(Lexer, TellsNumbersFromFields) {
  Lexer lexer("1.5 a.b 2");
  const auto tokens = tokens_of(lexer);
  ASSERT_EQ(tokens.size(), 6u);
  EXPECT_EQ(tokens[0].number, 1.5);
  EXPECT_EQ(tokens[2].sign, Sign::point);
  EXPECT_EQ(tokens[4].integer, 2);
}

TEST(Lexer, KnowsWordsAndSymbolsOfTheSameMeaning) {
  Lexer lexer("a and b && ge >= orange");
  const auto tokens = tokens_of(lexer);
  ASSERT_EQ(tokens.size(), 8u);
  EXPECT_EQ(tokens[0].sign, Sign::none);
  EXPECT_EQ(tokens[1].sign, Sign::both);
  EXPECT_EQ(tokens[3].sign, Sign::both);
  EXPECT_EQ(tokens[4].sign, Sign::greater_equal);
  EXPECT_EQ(tokens[5].sign, Sign::greater_equal);
  EXPECT_EQ(tokens[6].sign, Sign::none);
}

TEST(Lexer, SaysWhatIsWrongAndWhere) {
  EXPECT_EQ(failed("a = 1").error_offset(), 2u);
  EXPECT_NE(failed("a = 1").error().find("=="), std::string::npos);
  EXPECT_FALSE(failed("'\\u{d800}'").error().empty());
  EXPECT_FALSE(failed("1e999").error().empty());
  EXPECT_FALSE(failed("12ab").error().empty());
}

} // namespace

} // namespace parlour::script
