#include <gtest/gtest.h>

#include "adapters/nlu/text/characters.hpp"

namespace parlour::adapters::nlu {
namespace {

TEST(Characters, AreReadOneByOne) {
  struct {
    const char* text;
    char32_t code;
    std::uint32_t length;
  } const cases[] = {
      {"a", U'a', 1},
      {"\xC3\xA9", U'é', 2},
      {"\xE2\x82\xAC", U'€', 3},
      {"\xF0\x9F\x99\x82", U'\U0001F642', 4},
      {"\xC3", 0xFFFD, 1}, // cut off
      {"\xFF", 0xFFFD, 1},
      {"\xC0\xAF", 0xFFFD, 1},     // longer than needed
      {"\xED\xA0\x80", 0xFFFD, 1}, // half of a pair
  };
  for (const auto& [text, code, length] : cases) {
    const auto found = character_at(text, 0);
    EXPECT_EQ(found.code, code) << text;
    EXPECT_EQ(found.length, length) << text;
  }
  EXPECT_EQ(character_at("x\xC3\xA9", 1).code, U'é');
}

TEST(Characters, AreOfWordsOrNot) {
  for (const char32_t code : {U'a', U'Z', U'7', U'é', U'李', U'\u0301'})
    EXPECT_TRUE(is_word_character(code)) << static_cast<unsigned>(code);
  for (const char32_t code : {U' ', U'-', U'.', U'€', U'\uFFFD', U'\u3002'})
    EXPECT_FALSE(is_word_character(code)) << static_cast<unsigned>(code);
}

TEST(Characters, AreUpperOrNot) {
  EXPECT_TRUE(is_upper(U'Q'));
  EXPECT_TRUE(is_upper(U'É'));
  EXPECT_FALSE(is_upper(U'q'));
  EXPECT_FALSE(is_upper(U'é'));
  EXPECT_FALSE(is_upper(U'1'));
}

TEST(Characters, AreFolded) {
  std::string word;
  for (const char32_t code : {U'C', U'A', U'F', U'É', U'e', U'\u0301', U'Ü'})
    append_folded(word, code);
  EXPECT_EQ(word, "cafeeu");
}

} // namespace
} // namespace parlour::adapters::nlu
