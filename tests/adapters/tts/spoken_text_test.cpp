#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/tts/spoken_text.hpp"

namespace parlour::adapters::tts {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(SpokenText, splits_words_at_blanks) {
  EXPECT_THAT(speakable_words(" Good\tmorning,\n  Zoë. "),
              ElementsAre("Good", "morning,", "Zoë."));
  EXPECT_THAT(speakable_words(" \n"), IsEmpty());
}

TEST(SpokenText, keeps_markup_as_text) {
  EXPECT_THAT(speakable_words("a<b/> [[c]] &amp;"),
              ElementsAre("a<b/>", "[[c]]", "&amp;"));
}

// espeak-ng takes orders behind the character 1.
TEST(SpokenText, drops_what_is_no_character) {
  using namespace std::string_literals;
  EXPECT_THAT(speakable_words("a\x01\x31S b\0c\xff"
                              "d \xc2\x85 e\x7f"s),
              ElementsAre("a", "1S", "b", "c", "d", "e"));
}

TEST(SpokenText, cuts_endless_words_between_characters) {
  std::string word;
  for (int i = 0; i < 100; ++i)
    word += "é";
  const auto words = speakable_words(word);
  ASSERT_EQ(words.size(), 2u);
  EXPECT_EQ(count_characters(words[0]), 80u);
  EXPECT_EQ(words[0] + words[1], word);
}

std::vector<std::string> pieces(const std::string& text, PieceLength length) {
  std::vector<std::string> texts;
  for (const auto& piece : pieces_of(speakable_words(text), length))
    texts.push_back(joined(piece));
  return texts;
}

TEST(SpokenText, cuts_behind_sentences_that_are_long_enough) {
  EXPECT_THAT(pieces("One. Two three four? Five.", {10, 100}),
              ElementsAre("One. Two three four?", "Five."));
  EXPECT_THAT(pieces("(\"Is it so?\") It is.", {5, 100}),
              ElementsAre("(\"Is it so?\")", "It is."));
}

TEST(SpokenText, cuts_behind_no_abbreviation) {
  EXPECT_THAT(pieces("Call Dr. Ho at 3 p.m. today.", {1, 100}),
              ElementsAre("Call Dr. Ho at 3 p.m. today."));
}

TEST(SpokenText, cuts_long_sentences_behind_a_clause_or_anywhere) {
  EXPECT_THAT(pieces("one, two three four", {100, 14}),
              ElementsAre("one,", "two three", "four"));
  EXPECT_THAT(pieces("immeasurable things", {100, 5}),
              ElementsAre("immeasurable", "things"));
  EXPECT_THAT(pieces("", {1, 5}), IsEmpty());
}

} // namespace
} // namespace parlour::adapters::tts
